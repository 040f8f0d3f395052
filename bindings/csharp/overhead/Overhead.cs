// SPDX-License-Identifier: Apache-2.0
using System;
using System.Diagnostics;
using System.Globalization;
using System.Linq;
using Vesica;

/// <summary>What calls cost from C#: as bench/hosts/overhead.c does, with the same rectangles.</summary>
internal static class Overhead
{
    private const int Count = 1000000;

    private static Rect RectOf(long i)
    {
        bool odd = i % 2 == 1;
        return new Rect((i * 7919 % 4001) / 1000.0, (i * 104729 % 4003) / 1000.0, odd ? 5.0 / 13 : 0.8,
            odd ? 12.0 / 13 : 0.6, 0.5 + (i % 100) / 200.0, 0.5 + (i % 70) / 140.0);
    }

    private static double Least(int repeats, int calls, Action<int> call)
    {
        return Enumerable.Range(0, repeats).Min(repeat =>
        {
            var watch = Stopwatch.StartNew();
            for (int i = 0; i < calls; ++i) call(i);
            return watch.Elapsed.TotalMilliseconds / calls * 1e6;
        });
    }

    private static void Row(string question, Action<int> one, Action<int> many)
    {
        Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "C# {0} {1:0.###} {2:0.####} {3:0.####}",
            question, Least(100, 1000, one), Least(100, 1, i => many(1000)) / 1e3,
            Least(7, 1, i => many(Count)) / Count));
    }

    private static void Main()
    {
        Rect[] a = Enumerable.Range(0, Count).Select(i => RectOf(i)).ToArray();
        Rect[] b = Enumerable.Range(0, Count).Select(i => RectOf(3L * i + 1)).ToArray();
        Shapes allA = Shapes.Of(a), allB = Shapes.Of(b);
        Shapes someA = Shapes.Of(a.Take(1000).ToArray()), someB = Shapes.Of(b.Take(1000).ToArray());
        var hits = new bool[Count];
        double[][] c = Enumerable.Range(0, 5).Select(i => new double[Count]).ToArray();
        Row("overlap", i => Query.Overlap(a[i % 1000], b[i % 1000]),
            n => Query.OverlapMany(n == Count ? allA : someA, n == Count ? allB : someB, hits));
        Row("nearest", i => Query.Nearest(a[i % 1000], b[i % 1000]),
            n => Query.NearestMany(n == Count ? allA : someA, n == Count ? allB : someB, c[0], c[1], c[2], c[3], c[4]));
        Row("iou", i => Query.Iou(a[i % 1000], b[i % 1000]),
            n => Query.IouMany(n == Count ? allA : someA, n == Count ? allB : someB, c[0]));
    }
}
