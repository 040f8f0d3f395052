class Vesica < Formula
  desc "Exact overlap queries between plain 2D shapes"
  homepage "https://vesica.example.org"
  url "https://vesica.example.org/vesica-0.1.0.tar.gz"
  sha256 "0000000000000000000000000000000000000000000000000000000000000000"
  license "Apache-2.0"

  depends_on "cmake" => :build

  def install
    system "cmake", "-S", ".", "-B", "build", *std_cmake_args
    system "cmake", "--build", "build"
    system "cmake", "--install", "build"
  end

  test do
    (testpath/"test.c").write <<~C
      #include <vesica.h>
      int main(void) {
        vesica_circle_f64 a = {0, 0, 1}, b = {2, 0, 1};
        return vesica_overlap_f64(VESICA_CIRCLE, &a, VESICA_CIRCLE, &b) == 1 ? 0 : 1;
      }
    C
    system ENV.cc, "test.c", "-I#{include}", "-L#{lib}", "-lvesica", "-o", "test"
    system "./test"
  end
end
