// SPDX-License-Identifier: Apache-2.0
using System;
using System.Linq;
using System.Threading.Tasks;

namespace Vesica
{
    /// <summary>Calls that are divided among threads.</summary>
    internal static class Threads
    {
        // With fewer elements each, starting a thread takes longer than it saves.
        private const int Least = 50000;

        /// <summary>How many threads work on so many elements, if the caller asks for threads.</summary>
        internal static int Count(int threads, long elements)
        {
            return threads > 0 ? threads : (int)Math.Min(Environment.ProcessorCount, 1 + elements / Least);
        }

        /// <summary>The task of each part once, by at most so many threads at the same time. The first part's exception
        /// is thrown.</summary>
        internal static void EachPart(int threads, int parts, Action<int> task)
        {
            var thrown = new Exception[parts];
            Parallel.For(0, parts, new ParallelOptions { MaxDegreeOfParallelism = threads }, part =>
            {
                try
                {
                    task(part);
                }
                catch (Exception e)
                {
                    thrown[part] = e;
                }
            });
            Exception first = thrown.FirstOrDefault(e => e != null);
            if (first != null) System.Runtime.ExceptionServices.ExceptionDispatchInfo.Capture(first).Throw();
        }
    }
}
