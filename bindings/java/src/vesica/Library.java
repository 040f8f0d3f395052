// SPDX-License-Identifier: Apache-2.0
package vesica;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;

/** Loads the library inside the jar, or the one that the system property {@code vesica.library} names. */
final class Library {
  private Library() {}

  static void load() {
    String given = System.getProperty("vesica.library");
    System.load(given != null ? Path.of(given).toAbsolutePath().toString() : unpacked());
    requireVersion(Native.version());
  }

  private static String unpacked() {
    String system = System.getProperty("os.name") + "-" + System.getProperty("os.arch") + libc();
    String name = "/native/" + system + "/libvesica_jni.so";
    try (InputStream library = Library.class.getResourceAsStream(name)) {
      if (library == null) {
        throw new UnsatisfiedLinkError(
            "this jar has no library for " + system + ": build one, and name it by -Dvesica.library=FILE");
      }
      Path file = Files.createTempFile("libvesica_jni", ".so");
      Files.copy(library, file, StandardCopyOption.REPLACE_EXISTING);
      file.toFile().deleteOnExit();
      return file.toString();
    } catch (IOException e) {
      throw new UnsatisfiedLinkError("the library of the jar cannot be unpacked: " + e);
    }
  }

  /** "-musl" where this process runs with that C library, as on Alpine Linux. */
  private static String libc() {
    try {
      return Files.readString(Path.of("/proc/self/maps")).contains("/ld-musl-") ? "-musl" : "";
    } catch (IOException e) {
      return "";
    }
  }

  private static void requireVersion(int version) {
    if (version >= Native.VERSION) return;
    throw new UnsatisfiedLinkError(
        "libvesica " + version + " is older than " + Native.VERSION
            + ", which this package needs: install a newer one");
  }
}
