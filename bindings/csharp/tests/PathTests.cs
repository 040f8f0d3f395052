// SPDX-License-Identifier: Apache-2.0
using System;
using System.Linq;
using Vesica;

/// <summary>Polygons and polylines: one, arrays of them, and what is refused.</summary>
internal static class PathTests
{
    private static readonly double[] Frame = { 0, 0, 8, 0, 8, 8, 0, 8, 2, 2, 6, 2, 6, 6, 2, 6 };

    // Squares of side 2, 3 apart.
    private static readonly double[] Row =
    {
        0, 0, 2, 0, 2, 2, 0, 2, 3, 0, 5, 0, 5, 2, 3, 2, 6, 0, 8, 0, 8, 2, 6, 2
    };

    private static float[] Narrow(double[] numbers)
    {
        return numbers.Select(x => (float)x).ToArray();
    }

    private static void Same<T>(T got, T expected)
    {
        if (!Equals(got, expected)) throw new Exception(got + ", not " + expected);
    }

    private static void Refused<E>(string words, Action call) where E : Exception
    {
        try
        {
            call();
        }
        catch (E e)
        {
            if (e.Message.Contains(words)) return;
            throw new Exception("not '" + words + "'", e);
        }
        throw new Exception("not refused: " + words);
    }

    internal static void Test()
    {
        One();
        Floats();
        Arrays();
        Refusals();
        Collected();
    }

    private static void One()
    {
        Polygon frame = new Polygon(Frame, 0, 4, 8), triangle = new Polygon(new double[] { 0, 0, 4, 0, 0, 3 });
        var chain = new Polyline(new double[] { -1, 1, 9, 1, 9, 9 });
        Circle centre = new Circle(4, 4, 1);
        Aabb box = new Aabb(0, 0, 2, 9);
        Same(Query.Overlap(frame, centre), false);
        Same(Query.Overlap(frame, chain), true);
        Same(Query.InteriorsOverlap(frame, new Circle(4, 4, 2)), false);
        Same(Query.Relation(triangle, new Point(1, 1)), Relation.Contains);
        Same(Query.Contains(frame, new Circle(1, 1, 1)), true);
        Same(Query.Nearest(frame, centre).Distance, 1.0);
        Same(Query.BoundaryDistance(triangle, new Circle(1, 1, 0.5)).Distance, 0.5);
        Same(Query.Depth(triangle, new Point(1, 1)).Depth, 1.0);
        Same(Distances.Signed(triangle, new Point(-3, 0)), 3.0);
        Same(Distances.Within(triangle, new Point(-3, 0), 3), Within.Yes);
        Same(Query.Area(triangle, box), 4.5);
        Same(Query.Iou(frame, new Aabb(0, 0, 8, 8)), 0.75);
        Same(Measures.Ratio(Ratio.OverFirst, triangle, box), 0.75);
        Same(Query.ShapeArea(frame), 48.0);
        Same(Query.Bounds(triangle), new Aabb(0, 0, 4, 3));
        Query.Check(frame);
    }

    private static void Floats()
    {
        var frame = new Polygon(Narrow(Frame), 0, 4, 8);
        Same(Query.Overlap(frame, new CircleF(4, 4, 1)), false);
        Same(Query.ShapeArea(frame), 48.0);
        Shapes quads = Shapes.EvenPaths(Kind.Polygon, Narrow(Row), 4);
        Same(Query.OverlapSelect(frame, quads).Length, 3);
        Refused<ArgumentException>("convert one of them", () => Query.Overlap(frame, new Circle(4, 4, 1)));
    }

    private static void Arrays()
    {
        Shapes quads = Shapes.EvenPaths(Kind.Polygon, Row, 4);
        Shapes ringed = Shapes.Paths(Kind.Polygon, Row, new[] { 0, 4, 8, 12 });
        Shapes nested = Shapes.Paths(Kind.Polygon, Row, new[] { 0, 4, 8, 12 }, new[] { 0, 1, 3 });
        Shapes discs = Shapes.Of(new[] { new Circle(1, 1, 1), new Circle(4, 1, 1), new Circle(9, 9, 1) });
        Same(quads.Count + 10 * ringed.Count + 100 * nested.Count, 233L);
        var hits = new bool[3];
        Same(Query.OverlapMany(quads, discs, hits), 2L);
        Same(string.Join(" ", hits), "True True False");
        var relations = new Relation[3];
        Same(Query.RelationMany(quads, ringed, relations), 3L);
        Same(relations.All(x => x == Relation.Equal), true);
        var areas = new double[6];
        Same(Query.AreaMatrix(nested, quads, areas), 3L);
        Same(string.Join(" ", areas), "4 0 0 0 4 4");
        Same(string.Join(" ", Query.OverlapSelect(new Polygon(new[] { 1, 1, 4, 1, 4, 1.5 }), quads)), "0 1");
        Impact impact;
        Same(new Motion(-1, 0).CastFirst(new Polyline(new double[] { 9, 1, 9, 3 }), quads, out impact), 2L);
        using (ShapeIndex index = new ShapeIndex(quads, discs, nested), other = new ShapeIndex(ringed))
        {
            Same(index.Join(other).Length, 3 + 2 + 3);
            Same(index.Select(new Polygon(Frame, 0, 4, 8)).Length, 3 + 2 + 2);
        }
        Shapes none = Shapes.Paths(Kind.Polyline, new double[0], new[] { 0 });
        Same(Query.OverlapMany(none, none, new bool[0]), 0L);
    }

    private static void Refusals()
    {
        Refused<ArgumentException>("3 numbers are no pairs", () => new Polygon(new double[3]));
        Refused<ArgumentException>("no vertex", () => new Polyline(new float[0]));
        Refused<ArgumentNullException>("vertices", () => new Polyline((double[])null));
        Refused<ArgumentException>("ring offsets ascend from 0 to 8 at most: 9", () => new Polygon(Frame, 0, 9));
        Refused<ArgumentException>("1 follows 2", () => new Polygon(Frame, 0, 2, 1));
        Refused<ArgumentException>("-1 follows 0", () => new Polyline(Frame, -1, 2));
        Refused<ArgumentException>("8 vertices are no paths of 3", () => Shapes.EvenPaths(Kind.Polygon, Frame, 3));
        Refused<ArgumentException>("no paths of 0", () => Shapes.EvenPaths(Kind.Polygon, Frame, 0));
        Refused<ArgumentException>("a Rect has no rings", () => Shapes.EvenPaths(Kind.Rect, Frame, 4));
        Refused<ArgumentException>("any number of vertices", () => Shapes.Of(Kind.Polygon, Frame));
        Refused<ArgumentException>("no ring offsets", () => Shapes.Paths(Kind.Polygon, Frame, null));
        Refused<ArgumentException>("part offsets ascend from 0 to 2",
            () => Shapes.Paths(Kind.Polygon, Frame, new[] { 0, 4, 8 }, new[] { 0, 3 }));
        var frame = new Polygon(Frame, 0, 4, 8);
        Refused<VesicaException>("convex", () => Query.Depth(frame, new Point(1, 1)));
        Refused<VesicaException>("cross", () => Query.Check(new Polygon(new double[] { 0, 0, 4, 4, 4, 0, 0, 4 })));
        var broken = (double[])Row.Clone();
        broken[9] = double.NaN;
        var hits = new bool[3];
        Shapes quads = Shapes.EvenPaths(Kind.Polygon, broken, 4), probe = Shapes.Of(new[] { new Point(1, 1) });
        Refused<VesicaException>("invalid", () => Query.OverlapMany(quads, probe, hits));
        Same(string.Join(" ", hits), "True False False");
    }

    /// <summary>Memory is given back when nothing uses it, and not before.</summary>
    private static void Collected()
    {
        for (int i = 0; i < 200; ++i)
        {
            Same(Query.ShapeArea(new Polygon(Frame, 0, 4, 8)), 48.0);
            Shapes quads = Shapes.EvenPaths(Kind.Polygon, Row, 4);
            if (i % 20 == 0) GC.Collect();
            Same(Query.OverlapMany(quads, quads, new bool[3]), 3L);
        }
    }
}
