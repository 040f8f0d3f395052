// SPDX-License-Identifier: Apache-2.0
using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Vesica;

/// <summary>vectors FILE: the shared vectors (../vectors.txt) by Vesica.cs. Exit status 0 when all are right.</summary>
internal static class Vectors
{
    private static readonly List<int> lines = new List<int>(), expected = new List<int>();
    private static readonly List<Rect> rects = new List<Rect>();
    private static readonly List<Ellipse> ellipses = new List<Ellipse>();
    private static int calls = 0, status = 0;

    private static void Check(int line, long answer, int expected)
    {
        if (answer == expected) return;
        Console.WriteLine("line " + line + ": " + answer + ", not " + expected);
        status = 1;
    }

    /// <summary>What the call answers, or the code of its error.</summary>
    private static long Answer(Func<long> call)
    {
        try
        {
            return call();
        }
        catch (VesicaException e)
        {
            return e.Code;
        }
    }

    private static double[] Numbers(IEnumerable<string> words)
    {
        return words.Select(word => BitConverter.Int64BitsToDouble(Convert.ToInt64(word, 16))).ToArray();
    }

    private static float[] Narrow(double[] numbers)
    {
        return numbers.Select(number => (float)number).ToArray();
    }

    private static void Read(int line, string[] words)
    {
        int code = int.Parse(words[1]), kindA = int.Parse(words[2]), kindB = int.Parse(words[9]);
        double[] a = Numbers(words.Skip(3).Take(6)), b = Numbers(words.Skip(10));
        if (words[0] == "many")
        {
            lines.Add(line);
            expected.Add(code);
            rects.Add(new Rect { CX = a[0], CY = a[1], UX = a[2], UY = a[3], HX = a[4], HY = a[5] });
            ellipses.Add(new Ellipse { CX = b[0], CY = b[1], UX = b[2], UY = b[3], A = b[4], B = b[5] });
            return;
        }
        Func<bool> call = () => Shapes.Overlap(kindA, a, kindB, b);
        if (words[0] == "f32") call = () => Shapes.Overlap(kindA, Narrow(a), kindB, Narrow(b));
        Check(line, Answer(() => call() ? 1 : 0), code);
        ++calls;
    }

    private static void CheckBatch()
    {
        var hits = new byte[lines.Count];
        int valid = expected.FindIndex(code => code < 0);
        long count = Shapes.OverlapMany(rects.Take(valid).ToArray(), ellipses.Take(valid).ToArray(), hits);
        if (count != expected.Take(valid).Sum()) status = 1;
        // With an invalid element, an error: and yet every valid one has its answer.
        if (Answer(() => Shapes.OverlapMany(rects.ToArray(), ellipses.ToArray(), hits)) != -2) status = 1;
        for (int i = 0; i < hits.Length; ++i) Check(lines[i], hits[i], Math.Max(expected[i], 0));
    }

    private static int Main(string[] arguments)
    {
        int line = 0;
        foreach (string text in File.ReadLines(arguments[0]))
        {
            ++line;
            if (!text.StartsWith("#")) Read(line, text.Split(' '));
        }
        CheckBatch();
        try
        {
            Shapes.Overlap(Shapes.Point, new[] { double.NaN, 0 }, Shapes.Circle, new[] { 0.0, 0, 1 });
        }
        catch (VesicaException e)
        {
            Console.WriteLine("NaN: " + e.Message);
        }
        var p = Shapes.Nearest(Shapes.Aabb, new[] { 0.0, 0, 2, 2 }, Shapes.Circle, new[] { 6.0, 1, 1 });
        if (p.Distance == 3 && p.AX == 2 && p.AY == 1 && p.BX == 5 && p.BY == 1)
            Console.WriteLine("nearest: as in C");
        Console.WriteLine(calls + " calls, " + lines.Count + " in a batch");
        return status;
    }
}
