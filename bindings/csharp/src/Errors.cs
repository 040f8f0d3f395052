// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

[assembly: InternalsVisibleTo("VesicaTests")]

namespace Vesica
{
    /// <summary>What the library refuses.</summary>
    public sealed class VesicaException : ArgumentException
    {
        internal VesicaException(int code, object result = null)
            : base(Marshal.PtrToStringAnsi(Native.vesica_strerror(code)))
        {
            Code = (ErrorCode)code;
            Result = result;
        }

        /// <summary>The library's number.</summary>
        public ErrorCode Code { get; private set; }

        /// <summary>After an invalid shape, what a method that allocates its result has for all others.</summary>
        public object Result { get; private set; }
    }

    internal static unsafe partial class Native
    {
        // Found as libvesica.so, vesica.dll or libvesica.dylib.
        private const string Library = "vesica";

        static Native()
        {
            RequireVersion(vesica_version());
        }

        internal static void RequireVersion(int version)
        {
            if (version >= Version) return;
            throw new DllNotFoundException(
                "libvesica " + version + " is older than " + Version
                + ", which this assembly needs: install a newer one");
        }

        /// <summary>The answer, if it is one.</summary>
        internal static long Checked(long answer)
        {
            if (answer < 0) throw new VesicaException((int)answer);
            return answer;
        }
    }
}
