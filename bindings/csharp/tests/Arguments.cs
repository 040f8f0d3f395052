// SPDX-License-Identifier: Apache-2.0
using System;
using System.Linq;
using System.Threading;
using Vesica;

/// <summary>What is refused, what memory is taken, that nothing is copied, and that any arguments are
/// survived.</summary>
internal static unsafe class Arguments
{
    private static readonly Circle Disc = new Circle(0, 0, 1);
    private static readonly Shapes Three = Shapes.Of(new[] { Disc, Disc, Disc });

    private static void Refused<E>(string words, Action call) where E : Exception
    {
        try
        {
            call();
        }
        catch (E e)
        {
            if (e.Message.Contains(words)) return;
            throw new InvalidOperationException("not '" + words + "'", e);
        }
        throw new InvalidOperationException("not refused: " + words);
    }

    private static void Check(bool holds, string what)
    {
        if (!holds) throw new InvalidOperationException(what);
    }

    private static void Refusals()
    {
        Refused<VesicaException>("a shape is invalid", () => Query.Overlap(new Circle(0, 0, -1), Disc));
        Refused<VesicaException>("negative", () => Query.Check(new Circle(0, 0, -1)));
        Refused<ArgumentException>("one has double numbers", () => Query.Overlap(Disc, new CircleF(0, 0, 1)));
        Refused<ArgumentException>("Circle has 3 numbers", () => Query.Check(new AnyShape(Kind.Circle, true, 1, 2)));
        Refused<ArgumentException>("10 is not a kind", () => Shapes.Of((Kind)10, new double[3]));
        Refused<ArgumentException>("2 numbers are no records of 3", () => Shapes.Of(Kind.Circle, new double[2]));
        Refused<ArgumentNullException>("numbers", () => Shapes.Of(Kind.Circle, (double[])null));
        Refused<ArgumentNullException>("a", () => Query.OverlapMany(null, Three, new bool[3]));
        Shapes two = Shapes.Of(new[] { Disc, Disc });
        Refused<ArgumentException>("a has 3 shapes and b 2", () => Query.OverlapMany(Three, two, new bool[3]));
        Refused<ArgumentException>("where 9 are needed", () => Query.OverlapMatrix(Three, Three, new bool[8]));
        Refused<ArgumentException>("the output must have them too", () => Query.AreaMany(Three, Three, new float[3]));
        var numbers = new double[9];
        Shapes own = Shapes.Of(Kind.Circle, numbers);
        Refused<ArgumentException>("output overlaps an input", () =>
            Query.AreaMany(own, own, new Span<double>(numbers, 3, 3)));
        var both = new Rect[2];
        Refused<ArgumentException>("output overlaps an input", () =>
        {
            fixed (Rect* p = both) Query.OverlapMany(Shapes.Of(both), Shapes.Of(both), new Span<bool>((byte*)p - 1, 2));
        });
        Refused<VesicaException>("NULL", () =>
            Query.DepthMany(Three, Three, default(Span<double>), default(Span<double>), default(Span<double>)));
        Refused<ArgumentException>("1 or 3 velocities", () => Cast(new double[2], new double[1], numbers));
        Refused<ArgumentException>("overlaps the velocities", () => Cast(numbers.AsSpan(0, 3), new double[3], numbers));
        Refused<VesicaException>("", () => { Impact impact; new Motion(1, 0, -1).Cast(Disc, Disc, out impact); });
        Refused<ArgumentException>("9 numbers are no rows of 5", () => Boxes.Rects(numbers, Angle.Radians));
        Refused<VesicaException>("", () => Boxes.Rects(new double[5], (Angle)3));
        Refused<VesicaException>("", () => Boxes.Corners(Three, new double[24]));
        Refused<ArgumentException>("where 15 are needed", () => Boxes.Of(Three, Angle.Radians, new double[6]));
        Refused<ArgumentException>("labels or none", () =>
            Measures.Suppress(Three, new double[3], new Suppression(0.5) { Labels = new int[1] }));
        Refused<ArgumentException>("3 shapes need as many scores, not 1", () => Query.Nms(Three, new double[1], 0.5));
        Refused<ArgumentException>("four corners have 8 numbers", () => Make.RectFromCorners(1, 2));
        Refused<ArgumentException>("four corners have 8 numbers", () => Make.RectCornersMisfit(null, new Rect()));
        Refused<ArgumentException>("1 to 64 arrays", () => new ShapeIndex());
        Refused<VesicaException>("index", () => ShapeIndex.FromBytes(new byte[640], Three));
        var index = new ShapeIndex(Three);
        Refused<ArgumentException>("an index of 3 shapes cannot be that of 6", () =>
            ShapeIndex.FromBytes(index.ToBytes(), Three, Three));
        Refused<VesicaException>("", () => index.Join(index, JoinQuery.Overlap, 2, 2));
        Refused<ArgumentException>("k is 0", () => index.NearestOfEach(0, 1, Three));
        Refused<ArgumentException>("rows of 2147483647 for 3 shapes", () =>
            index.NearestOfEach(int.MaxValue, 1, Three));
        index.Dispose();
        Refused<ObjectDisposedException>("ShapeIndex", () => index.Join(index));
        index.Dispose();
        Shapes none = Shapes.Of(new Rect[0]);
        Check(Query.OverlapMany(none, none, default(Span<bool>)) == 0, "empty arrays");
        Check(new ShapeIndex(none).Join(new ShapeIndex(none)).Length == 0, "empty indexes");
    }

    /// <summary>What is computed of all others comes with the exception, but nothing if nothing was.</summary>
    private static void Results()
    {
        Shapes vast = Shapes.At(Kind.Circle, true, (IntPtr)8, 3, long.MaxValue);
        var some = Shapes.Of(new[] { Disc, new Circle(0, 0, -1), Disc });
        foreach (Shapes many in new[] { vast, some })
            try
            {
                Query.OverlapSelect(Disc, many);
                throw new InvalidOperationException("nothing is wrong");
            }
            catch (VesicaException e)
            {
                var found = (long[])e.Result;
                Check(many == some ? found.SequenceEqual(new long[] { 0, 2 }) : found == null, "a result");
            }
        Refused<VesicaException>("a shape is invalid", () => Query.OverlapSelect(new Circle(0, 0, -1), Three));
        double[] numbers = { 0, 0, 1 };
        var any = new AnyShape(Kind.Circle, true, numbers);
        numbers[0] = 9;
        Check(Query.Overlap(any, Disc), "a shape follows its caller's array");
    }

    /// <summary>An array that is pinned, and in vain: the next one cannot be.</summary>
    private static WeakReference PinnedInVain(bool isAsked)
    {
        var circles = new Circle[1000];
        Shapes shapes = Shapes.Of(circles);
        Refused<NullReferenceException>("", () =>
        {
            if (isAsked) Query.Ask((wide, a, b, output) => 0, shapes, null, null);
            else new Pinned(shapes, null).Dispose();
        });
        return new WeakReference(circles);
    }

    /// <summary>Arrays do not stay pinned.</summary>
    private static void PinsAreReleased()
    {
        WeakReference[] all = Enumerable.Range(0, 200).Select(i => PinnedInVain(i % 2 == 0)).ToArray();
        GC.Collect();
        // The collector takes some numbers on the stack for references.
        Check(all.Count(each => each.IsAlive) < 50, "arrays that stay pinned");
    }

    /// <summary>An index that is disposed of while a thread is inside a call, and twice at the same time.</summary>
    private static void DisposedDuringCalls()
    {
        const int Many = 30000;
        Circle[] near = Enumerable.Range(0, Many).Select(i => new Circle(i, 0, 1000)).ToArray();
        Circle[] far = Enumerable.Range(0, Many).Select(i => new Circle(3 * i, 0, 1)).ToArray();
        long expected, found = -1;
        using (var whole = new ShapeIndex(Shapes.Of(near))) expected = whole.JoinCount(whole);
        for (int i = 0; i < 3; ++i)
        {
            var index = new ShapeIndex(Shapes.Of(near));
            var asks = new Thread(() =>
            {
                try
                {
                    found = index.JoinCount(index);
                }
                catch (ObjectDisposedException)
                {
                    found = expected; // it has asked too late
                }
            });
            var disposes = new Thread(index.Dispose);
            asks.Start();
            Thread.Sleep(20);
            disposes.Start();
            index.Dispose();
            Refused<ObjectDisposedException>("ShapeIndex", () => index.Bounds());
            disposes.Join();
            // Others that would get its memory, had it been freed.
            for (int k = 0; k < 4; ++k) GC.KeepAlive(new ShapeIndex(Shapes.Of(far)));
            asks.Join();
            Check(found == expected, "a call that was not over has " + found + " pairs, not " + expected);
        }
    }

    /// <summary>One shape of it is as good as any, but an array has too few numbers.</summary>
    private struct Tiny : IShape
    {
        internal double X;

        public Kind Kind { get { return Kind.Rect; } }

        public bool IsDouble { get { return true; } }

        public void Write(void* numbers)
        {
            for (int i = 0; i < 6; ++i) ((double*)numbers)[i] = i == 2 ? 1 : X;
        }
    }

    /// <summary>In an array something lies between the numbers of its shapes.</summary>
    private struct Tagged : IShape
    {
        internal Circle Shape;
        internal long Tag;

        public Kind Kind { get { return Shape.Kind; } }

        public bool IsDouble { get { return true; } }

        public void Write(void* numbers)
        {
            ((IShape)Shape).Write(numbers);
        }
    }

    /// <summary>As large as a point, but not its numbers.</summary>
    private struct Named : IShape
    {
        internal string Name;
        internal double Y;

        public Kind Kind { get { return Kind.Point; } }

        public bool IsDouble { get { return true; } }

        public void Write(void* numbers)
        {
            ((double*)numbers)[0] = ((double*)numbers)[1] = Y;
        }
    }

    /// <summary>Just the numbers of a circle.</summary>
    private struct Whole : IShape
    {
        internal CircleF Shape;

        public Kind Kind { get { return Kind.Circle; } }

        public bool IsDouble { get { return false; } }

        public void Write(void* numbers)
        {
            ((IShape)Shape).Write(numbers);
        }
    }

    /// <summary>Nothing is read beyond an array of structs that are not of this assembly.</summary>
    private static void OwnStructs()
    {
        var yes = new bool[1 << 20];
        Refused<ArgumentException>("Tiny has 8 bytes, where the numbers of a Rect have 48", () =>
            Query.OverlapMany(Shapes.Of(new Tiny[1 << 20]), Shapes.Of(new Tiny[1]), yes));
        Refused<ArgumentException>("Tagged has 32 bytes, where the numbers of a Circle have 24", () =>
            Shapes.Of(new Tagged[0]));
        Refused<ArgumentException>("", () => Shapes.Of(new Named[1]));
        Shapes own = Shapes.Of(new[] { new Whole { Shape = new CircleF(5, 0, 1) }, new Whole() });
        Shapes origin = Shapes.Of(new[] { new PointF(0, 0) });
        Check(Query.OverlapMany(own, origin, yes) == 1 && yes[1], "structs of one's own");
        Check(Query.Overlap(new Tiny { X = 1 }, Disc), "a struct of one's own");
    }

    /// <summary>Columns of one array are results as any others, unless they share numbers.</summary>
    private static void ColumnsOfOneArray()
    {
        var all = new double[7];
        double[] still = new double[1];
        const string Words = "output overlaps another one";
        Refused<ArgumentException>(Words, () => Query.NearestMany(Three, Three, all, all, null, null, null));
        Refused<ArgumentException>(Words, () =>
            Query.NearestMany(Three, Three, all, null, null, null, all.AsSpan(2)));
        Refused<ArgumentException>(Words, () =>
            Query.BoundaryDistanceMany(Three, Three, null, all.AsSpan(2, 3), null, null, all));
        Refused<ArgumentException>(Words, () => Query.DepthMany(Three, Three, all, null, all.AsSpan(2)));
        Refused<ArgumentException>(Words, () =>
            Motion.CastMany(Three, Three, still, still, 1, all, null, null, all.AsSpan(2), null));
        Check(Query.DepthMany(Three, Three, all, null, all.AsSpan(3)) == 3 && all[2] == 2, "columns side by side");
    }

    /// <summary>Results are not written over shapes in memory of the caller's, whichever way they follow one
    /// another.</summary>
    private static void OverMemory()
    {
        var circles = new double[9];
        fixed (double* p = circles)
        {
            var start = (IntPtr)p;
            foreach (Shapes there in new[]
                { Shapes.At(Kind.Circle, true, start, 3, 24), Shapes.At(Kind.Circle, true, start + 48, 3, -24) })
            {
                Refused<ArgumentException>("output overlaps an input", () =>
                    Query.AreaMany(there, Three, circles.AsSpan(6)));
                Refused<ArgumentException>("output overlaps an input", () =>
                    Query.AreaMany(Three, there, circles.AsSpan(0, 3)));
            }
            Shapes last = Shapes.At(Kind.Circle, true, start + 48, 1, 24);
            Check(Query.AreaMany(Three, last, circles.AsSpan(3, 3)) == 0, "results beside memory of the caller's");
        }
    }

    private static void Cast(ReadOnlySpan<double> vx, ReadOnlySpan<double> vy, Span<double> t)
    {
        var none = default(Span<double>);
        Motion.CastMany(Three, Three, vx, vy, 1, t, none, none, none, none);
    }

    private static void Cast(Shapes at, double[] vx, double[] t)
    {
        var none = default(Span<double>);
        Motion.CastMany(at, Shapes.Of(new[] { Disc }), vx, new double[vx.Length], 99, t, none, none, none, none);
    }

    private static void MeasuresAndBoxes()
    {
        Rect[] rects = Boxes.Rects(new double[] { 1, 2, 6, 4, 90, 77, 3, 4, 5, 2, 180, 77 }, Angle.Degrees, 6);
        Check(rects[0].Equals(new Rect(1, 2, 0, 1, 3, 2)), "a box");
        double[] boxes = new double[10], corners = new double[16], depths = new double[4];
        Boxes.Of(Shapes.Of(rects), Angle.Quarters | Angle.Reversed, boxes);
        Check(boxes.SequenceEqual(new double[] { 1, 2, 6, 4, -1, 3, 4, 5, 2, 2 }), "boxes");
        Boxes.Corners(Shapes.Of(rects), corners);
        Check(corners[0] == 3 && corners[1] == -1, "corners");
        Check(Query.DepthMatrix(Shapes.Of(rects), Shapes.Of(rects), depths) == 4 && depths[0] == 4, "depths");
        try
        {
            Boxes.Rects(new double[] { 1, 2, 6, 4, 90, 3, 4, -5, 2, 180 }, Angle.Degrees);
            throw new InvalidOperationException("an invalid box");
        }
        catch (VesicaException e)
        {
            Check(e.Code == ErrorCode.Shape && ((Rect[])e.Result)[0].Equals(rects[0]), "an invalid box");
        }
        Aabb small = new Aabb(0, 0, 2, 2), large = new Aabb(0, 0, 4, 4);
        Check(Measures.Ratio(Ratio.OverSecond, small, large) == 0.25, "ratio");
        Shapes both = Shapes.Of(new[] { small, large });
        var how = new Suppression(0.5) { Ratio = Ratio.OverSmaller };
        Check(Measures.Suppress(both, new double[] { 1, 2 }, how).Length == 1, "by the smaller");
        how.Labels = new[] { 1, 2 };
        Check(Measures.Suppress(both, new double[] { 1, 2 }, how).Length == 2, "by labels");
        how.LeastScore = 1.5;
        Check(Measures.Suppress(both, new double[] { 1, 2 }, how).Length == 1, "by a least score");
    }

    private static void Motions()
    {
        Aabb wall = new Aabb(10, -5, 12, 5);
        Impact impact, met = new Impact(3, 10, 0, -1, 0);
        var east = new Motion(3, 0, 9);
        Check(east.Cast(wall, Disc, out impact) == Vesica.Cast.Hit && impact.Equals(met), "cast");
        Check(new Motion(3, 0, 2.5).Cast(wall, Disc, out impact) == Vesica.Cast.Miss, "too late");
        Check(east.Cast(wall, wall, out impact) == Vesica.Cast.Start, "at the start");
        Shapes walls = Shapes.Of(new[] { new Aabb(20, -5, 22, 5), wall, wall });
        Check(east.CastFirst(Disc, walls, out impact) == 1 && impact.Equals(met), "the first");
        Check(new Motion(-3, 0).CastFirst(Disc, walls, out impact) == -1, "none");
        using (var index = new ShapeIndex(walls))
        {
            Check(index.Cast(Disc, new Motion(1, 0, 10)).Length == 2, "items");
            Check(index.CastFirst(Disc, east, out impact) == 1 && impact.Equals(met), "the first of an index");
        }
        Check(Query.Contains(new Motion(3, 0, 2).Bounds(Disc), new Aabb(-1, -1, 7, 1)), "bounds of a motion");
        double[] t = new double[3], vx = { 2, -1, double.NaN };
        Refused<VesicaException>("", () => Cast(walls, vx, t));
        Check(t[0] == 9.5 && t[1] == double.PositiveInfinity && double.IsNaN(t[2]), "times");
    }

    private static void Turns()
    {
        var bar = new Segment(-1, 0, 1, 0);
        var speck = new Circle(0, 0.5, 1e-8);
        var wall = new Aabb(10, -5, 12, 5);
        Turn still = new Turn(), half = new Turn(0, 0, Math.PI), fast = new Turn(0, 0, 2e6);
        Impact impact;
        double gap;
        Cast found = Motion.ImpactTime(bar, half, speck, still, 1e-7, out impact, out gap);
        Check(found == Vesica.Cast.Hit && impact.T <= 0.5 && impact.T > 0.499999 && gap <= 1e-7, "a hit");
        found = Motion.ImpactTime(bar, new Turn(0, 0, 1.57), speck, still, 1e-7, out impact, out gap);
        Check(found == Vesica.Cast.Miss && impact.T == double.PositiveInfinity && double.IsNaN(gap), "a miss");
        // Without area contact is never proved.
        found = Motion.ImpactTime(bar, half, new Point(0, 0.5), still, 1e-7, out impact, out gap);
        Check(found == Vesica.Cast.Near, "near");
        found = Motion.ImpactTime(wall, half, wall, still, 1, out impact, out gap);
        Check(found == Vesica.Cast.Start && impact.T == 0 && gap == 0, "at the start");
        Refused<VesicaException>("", () => Motion.ImpactTime(wall, still, speck, still, 0, out impact, out gap));
        Refused<VesicaException>("", () => Motion.ImpactTime(wall, fast, speck, still, 1, out impact, out gap));
        Refused<ArgumentException>("one has double", () =>
            Motion.ImpactTime(wall, still, new CircleF(0, 0, 1), still, 1, out impact, out gap));
    }

    private static void Topologies()
    {
        Aabb a = new Aabb(0, 0, 2, 2), b = new Aabb(1, 1, 3, 3), far = new Aabb(5, 0, 7, 2);
        var disc = new Circle(6, 1, 1);
        Check(Distances.Within(a, disc, 3) == Within.Yes, "within");
        Check(Distances.Within(a, disc, 2.999) == Within.No, "not within");
        Ellipse left = new Ellipse(-2, 0, 1, 0, 2, 1), right = new Ellipse(5, 0, 1, 0, 2, 1);
        Check(Distances.Within(new Point(0, 0), right, 3) == Within.Yes, "a point within");
        Check(Distances.Within(left, right, 3) == Within.Nearly, "nearly within");
        Shapes boxes = Shapes.Of(new[] { a, b, far }), one = Shapes.Of(new[] { a });
        var near = new Within[3];
        Check(Distances.WithinMany(boxes, one, 2, near) == 2 && near[2] == Within.No, "within, of many");
        var signed = new double[3];
        Check(Distances.SignedMany(boxes, one, signed) == 2, "signed distances");
        Check(signed.SequenceEqual(new double[] { -2, -1, 3 }), "signed distances");
        using (ShapeIndex index = new ShapeIndex(boxes), other = new ShapeIndex(one))
            Check(index.JoinWithin(other, 2).Length == 2, "a join within a distance");
        Check(Topology.De9im(a, new Aabb(2, 0, 4, 2)) == "FF2F11212", "a matrix");
        Check(Topology.Matches("FF2F11212", "FF*FT****"), "a pattern");
        Check(Topology.Intersection(a, b)[0].Equals(new Point(1, 1)), "a region");
        Check(Topology.Intersection(a, far).Length == 0, "no region");
        foreach (string pattern in new[] { "T*", "T********\0", "\u00e9********", "X********" })
            Refused<VesicaException>("", () => Topology.Matches("FF2F11212", pattern));
        Refused<VesicaException>("", () => Topology.Intersection(a, disc));
        Refused<VesicaException>("", () => Distances.Within(a, b, double.NaN));
        Check(Distances.Within(a, b, -1) == Within.Yes, "deep enough");
        Shapes soft = Shapes.Of(new[] { new Aabb(0, 0, 4, 4), new Aabb(0, 0, 4, 3), new Aabb(9, 9, 10, 10) });
        Kept[] kept = Soft.Suppress(soft, new[] { 1, 0.75, 0.5 }, new SoftSuppression(Decay.Linear, 0.5));
        Check(kept.Select(each => each.Item).SequenceEqual(new long[] { 0, 2, 1 }), "soft suppression");
        Check(kept[2].Score == 0.1875, "a score that is left");
    }

    private static void CapsulesAndRoundedRectangles()
    {
        var bar = new Capsule(0, 0, 4, 0, 1);
        var rounded = new RoundRect(10, 0, 1, 0, 2, 1, 0.5);
        Check(Query.Overlap(bar, new Point(5, 0)), "the end of a capsule");
        Check(!Query.Overlap(bar, new Point(5, double.Epsilon)), "beyond the end of a capsule");
        Check(Query.Nearest(bar, rounded).Distance == 2.5, "the distance of a rounded rectangle");
        Check(Query.Bounds(rounded).Equals(new Aabb(7.5, -1.5, 12.5, 1.5)), "bounds of a rounded rectangle");
        var any = new AnyShape(Kind.RoundRect, true, 10, 0, 1, 0, 2, 1, 0.5);
        Shapes bars = Shapes.Of(new[] { bar, new Capsule(0, 5, 4, 5, 1) });
        Shapes two = Shapes.Of(new[] { rounded, new RoundRect(10, 0, 1, 0, 2, 1, 0.25) });
        var distances = new double[2];
        Query.NearestMany(Shapes.Of(new[] { bar }), two, distances, default(Span<double>), default(Span<double>),
            default(Span<double>), default(Span<double>));
        Check(distances.SequenceEqual(new[] { 2.5, 2.75 }), "distances of rounded rectangles");
        using (var index = new ShapeIndex(bars))
        {
            Check(index.Select(new Point(5, 0)).SequenceEqual(new long[] { 0 }), "an index of capsules");
            Check(index.Nearest(any, 1, 9)[0].Distance == 2.5, "the nearest capsule");
        }
        Check(Query.Area(bar, rounded) == 0, "the area that two share");
        var disc = new Ellipse(10, 0, 1, 0, 1, 1);
        Check(Query.Contains(rounded, disc), "an ellipse in a rounded rectangle");
        Check(Query.BoundaryDistance(rounded, disc).Distance == 0.5, "an ellipse's outline in another");
    }

    private static void Layouts()
    {
        Shapes records = Shapes.Of(Kind.Circle, new double[] { 0, 0, 1, 77, 5, 0, 1, 77 }, 4);
        Shapes columns = Shapes.Columns(Kind.Circle, new double[] { 0, 5, 0, 0, 1, 1 });
        var relations = new Relation[2];
        Check(Query.RelationMany(records, columns, relations) == 2 && relations[1] == Relation.Equal, "layouts");
        double* memory = stackalloc double[3];
        memory[0] = 5;
        memory[1] = 0;
        memory[2] = 1;
        Shapes there = Shapes.At(Kind.Circle, true, (IntPtr)memory, 1, 24);
        var yes = new bool[2];
        Check(Query.OverlapMany(records, there, yes) == 1 && yes[1], "memory of the caller's");
    }

    /// <summary>Results about a million rectangles need less memory than a copy of one column.</summary>
    private static void NothingIsCopied()
    {
        var shapes = Shapes.Of(Enumerable.Repeat(new Rect(0, 0, 1, 0, 1, 1), 1000000).ToArray());
        var yes = new bool[1000000];
        long before = GC.GetTotalMemory(true);
        Check(Query.OverlapMany(shapes, shapes, yes) == 1000000, "all");
        Check(GC.GetTotalMemory(false) - before < 4000000, "memory was taken");
    }

    private const int Questions = 23;

    private static void AnyArguments(int calls)
    {
        int seed = Environment.TickCount;
        Console.WriteLine("seed " + seed);
        var any = new Any(seed);
        var answered = new int[Questions];
        for (int i = 0; i < calls; ++i)
        {
            int question = any.Below(Questions);
            try
            {
                any.Call(question);
                ++answered[question];
            }
            catch (ArgumentException)
            {
                // as it should be
            }
        }
        string told = "answered: " + string.Join(" ", answered) + " of " + calls;
        Console.WriteLine(told);
        // Bytes that are 0 are no index.
        Check(calls < 5000 || answered.Take(Questions - 1).Min() > 0, told);
    }

    /// <summary>Random calls.</summary>
    private sealed class Any
    {
        private static readonly double[] All =
            { 0, -0.0, 1, -1, 0.5, double.NaN, double.PositiveInfinity, 5e-324, 1.7e308, 1e-200 };

        private readonly Random draw;

        internal Any(int seed)
        {
            draw = new Random(seed);
        }

        internal int Below(int most)
        {
            return draw.Next(most);
        }

        private double Special()
        {
            return All[draw.Next(All.Length)];
        }

        /// <summary>Capsules and rounded rectangles come seldom: many questions are not for them.</summary>
        private Kind SomeKind()
        {
            return (Kind)draw.Next(draw.Next(4) == 0 ? 8 : 6);
        }

        private Turn Turn()
        {
            return new Turn(draw.Next(9) - 4, draw.Next(5) - 2, Special());
        }

        private double[] Some(Kind kind)
        {
            return Enumerable.Range(0, draw.Next(4) == 0 ? draw.Next(40) : Shapes.Fields(kind) * draw.Next(6))
                .Select(i => draw.Next(40) == 0 ? Special() : draw.Next(9)).ToArray();
        }

        /// <summary>The first shape of some numbers, or an exception if there is none.</summary>
        private static AnyShape Single(Kind kind, double[] numbers)
        {
            return new AnyShape(kind, true, numbers.Take(Shapes.Fields(kind)).ToArray());
        }

        internal void Call(int question)
        {
            Kind kindA = SomeKind(), kindB = SomeKind();
            double[] first = Some(kindA), second = Some(kindB);
            if (question < 15) OfArrays(question, kindA, kindB, first, second);
            else OfTwo(question, Single(kindA, first), Single(kindB, second));
        }

        private void OfArrays(int question, Kind kindA, Kind kindB, double[] first, double[] second)
        {
            var none = default(Span<double>);
            double[] output = new double[draw.Next(100)];
            Shapes a = draw.Next(2) == 0 ? Shapes.Of(kindA, first) : Shapes.Columns(kindA, first);
            Shapes b = draw.Next(9) == 0 ? null : Shapes.Of(kindB, second);
            double[] scores = new double[a.Count + draw.Next(3) / 2];
            switch (question)
            {
                case 0: Query.OverlapMany(a, b, new bool[draw.Next(100)]); break;
                case 1: Query.ContainsMatrix(a, b, new bool[draw.Next(100)]); break;
                case 2: Query.AreaMany(a, b, draw.Next(5) == 0 ? second : output); break;
                case 3: Query.IouMatrix(a, b, output); break;
                case 4: Query.DepthMany(a, b, none, output, none); break;
                case 5: Query.Nms(a, scores, Special()); break;
                case 6: using (var index = new ShapeIndex(a, b)) index.Join(index, (JoinQuery)draw.Next(5)); break;
                case 7: using (var index = new ShapeIndex(a)) index.NearestOfEach(draw.Next(4), Special(), b, a); break;
                case 8: Measures.RatioMany((Ratio)draw.Next(9) - 1, a, b, output); break;
                case 9: Boxes.Of(a, (Angle)draw.Next(10) - 1, output); break;
                case 10: Boxes.Rects(second, (Angle)draw.Next(10) - 1, draw.Next(9)); break;
                case 11: Motion.CastMany(a, b, scores, scores, Special(), output, none, none, none, none); break;
                case 12: Distances.WithinMatrix(a, b, Special(), new Within[draw.Next(100)]); break;
                case 13:
                    Soft.Suppress(a, scores, new SoftSuppression((Decay)(draw.Next(3) - draw.Next(2)), Special()));
                    break;
                default: Distances.SignedMany(a, b, output); break;
            }
        }

        private void OfTwo(int question, AnyShape a, AnyShape b)
        {
            Impact impact;
            double gap;
            var motion = new Motion(Special(), draw.Next(5) - 2, Special());
            string[] patterns = { "T*F**FFF*", "0123T*F**", "T*", "", "\0", null };
            switch (question)
            {
                case 15: Distances.Within(a, b, Special()); break;
                case 16: Distances.Signed(a, b); break;
                case 17: Topology.Intersection(a, b); break;
                case 18: Topology.Matches(Topology.De9im(a, b), patterns[draw.Next(6)]); break;
                case 19: motion.Cast(a, b, out impact); break;
                case 20: Motion.ImpactTime(a, Turn(), b, Turn(), Special(), out impact, out gap); break;
                case 21: using (var index = new ShapeIndex(Three)) index.Cast(a, motion); break;
                default: ShapeIndex.FromBytes(new byte[draw.Next(900)], Three); break;
            }
        }
    }

    private static Shapes Scattered(int seed, int n, bool wide)
    {
        var random = new Random(seed);
        var numbers = new double[6 * n];
        for (int i = 0; i < numbers.Length; i += 6)
        {
            numbers[i] = 300 * random.NextDouble();
            numbers[i + 1] = 300 * random.NextDouble();
            numbers[i + 2] = 1;
            numbers[i + 3] = random.NextDouble();
            numbers[i + 4] = 0.5;
            numbers[i + 5] = 0.3;
        }
        if (seed == 2) numbers[4] = -1;
        return wide ? Shapes.Of(Kind.Rect, numbers)
            : Shapes.Of(Kind.Rect, numbers.Select(number => (float)number).ToArray());
    }

    private static void AnyNumberOfThreads(bool wide)
    {
        Shapes a = Scattered(1, 60000, wide), b = Scattered(2, 70000, wide);
        using (ShapeIndex alone = new ShapeIndex(a), other = new ShapeIndex(b))
        using (var odd = new ShapeIndex(Scattered(1, 9, !wide)))
        {
            Pair[] pairs = alone.Join(other);
            Check(pairs.Length > 60000 && pairs.Length == alone.JoinCount(other), "pairs");
            for (int threads = 0; threads < 6; ++threads)
                using (var first = ShapeIndex.BuildParallel(threads, a))
                using (var second = ShapeIndex.BuildParallel(threads, b))
                {
                    Check(first.ToBytes().SequenceEqual(alone.ToBytes()), "bytes by " + threads + " threads");
                    Check(second.ToBytes().SequenceEqual(other.ToBytes()), "bytes by " + threads + " threads");
                    Check(!first.Incomplete && second.Incomplete, "invalid shapes by " + threads + " threads");
                    Pair[] found = first.JoinParallel(second, JoinQuery.Overlap, threads);
                    Check(found.Select(pair => pair.A).SequenceEqual(pairs.Select(pair => pair.A)), "first items");
                    Check(found.Select(pair => pair.B).SequenceEqual(pairs.Select(pair => pair.B)), "second items");
                }
            Refused<ArgumentException>("-1 threads", () => ShapeIndex.BuildParallel(-1, a));
            Refused<ArgumentException>("-1 threads", () => alone.JoinParallel(other, JoinQuery.Overlap, -1));
            Refused<ArgumentException>("double", () => alone.JoinParallel(odd, JoinQuery.Overlap, 3));
        }
    }

    private static void Detections(bool wide)
    {
        Shapes a = Scattered(3, 900, wide), b = Scattered(4, 800, wide);
        RatioPair[] pairs;
        using (ShapeIndex first = new ShapeIndex(a), second = new ShapeIndex(b))
            pairs = first.JoinRatio(second, Ratio.OverSmaller, 0.25);
        var matrix = new double[900 * 800];
        var narrow = new float[900 * 800];
        if (wide) Measures.RatioMatrix(Ratio.OverSmaller, a, b, matrix);
        else Measures.RatioMatrix(Ratio.OverSmaller, a, b, narrow);
        if (!wide) matrix = narrow.Select(x => (double)x).ToArray();
        Check(pairs.Length > 3 && pairs.Length == matrix.Count(x => x >= 0.25), "sparse ratios");
        Check(pairs.All(pair => matrix[pair.A * 800 + pair.B] == pair.Value), "a sparse ratio");

        Func<long, long, double, RatioPair> of = (i, j, value) => new RatioPair { A = i, B = j, Value = value };
        long[] chosen = Detection.AssignGreedy(
            new[] { of(0, 0, 0.5), of(5, 0, 0.75), of(0, 1, 0.25), of(5, 1, 0.625), of(2, 2, double.NaN) });
        Check(chosen.SequenceEqual(new long[] { 1, 2 }), "assignment");
        Check(Detection.AssignGreedy(new RatioPair[0]).Length == 0, "assignment of nothing");
        Refused<VesicaException>("", () => Detection.AssignGreedy(new[] { of(-1, 0, 1) }));

        double[] numbers = { 0, 0, 4, 4, 0.5, 0, 4.5, 4, 20, 0, 24, 4 }, scores = { 0.75, 0.25, 0.5 };
        Shapes boxes = wide ? Shapes.Of(Kind.Aabb, numbers)
            : Shapes.Of(Kind.Aabb, numbers.Select(x => (float)x).ToArray());
        Fused fused = Detection.Fuse(boxes, scores);
        Check(fused.Numbers.SequenceEqual(new[] { 0.125, 0, 4.125, 4, 20, 0, 24, 4 }), "means");
        Check(fused.Scores.SequenceEqual(new[] { 0.5, 0.5 }), "scores");
        Check(fused.Clusters.SequenceEqual(new long[] { 0, 0, 1 }), "clusters");
        Fused best = Detection.Fuse(boxes, scores, new Fusion { Score = FusedScore.Max });
        Check(best.Scores[0] == 0.75, "the highest score");
        Fused weighed = Detection.Fuse(boxes, new[] { 0.5, 0.5, 0.5 }, new Fusion { Weights = new[] { 3.0, 1, 1 } });
        Check(weighed.Numbers[0] == 0.125, "weights");
        Fused labelled = Detection.Fuse(boxes, scores, new Fusion { Labels = new[] { 1, 2, 1 } });
        Check(labelled.Clusters.SequenceEqual(new long[] { 0, 2, 1 }), "labels");
        try
        {
            Detection.Fuse(boxes, new[] { 0.75, -1, 0.5 });
            Check(false, "a negative score");
        }
        catch (VesicaException e)
        {
            Check(((Fused)e.Result).Clusters.SequenceEqual(new long[] { 0, -1, 1 }), "without an invalid score");
        }
        Refused<ArgumentException>("3 boxes need as many scores", () => Detection.Fuse(boxes, new double[2]));
        Refused<VesicaException>("kind", () => Detection.Fuse(Three, scores));

        // Detection 1 is better than 0 and takes truth 0; 2 takes a crowd.
        RatioPair[] hits = { of(0, 0, 0.875), of(1, 0, 0.75), of(2, 1, 0.875) };
        long[] taken;
        Outcome[] outcomes = Detection.MatchTruths(MatchRule.Coco, hits, new[] { 0.5, 1, 0.25 },
            new[] { Truth.Counts, Truth.Crowd }, new[] { 0.5, 0.8 }, out taken);
        Check(outcomes.Select(outcome => (int)outcome).SequenceEqual(new[] { 0, 1, 2, 1, 0, 2 }), "outcomes");
        Check(taken.SequenceEqual(new long[] { -1, 0, 1, 0, -1, 1 }), "taken");
        // One hit of two truths, after a miss: the best precision is 1/2 up to recall 1/2, then 0.
        Outcome[] three = { Outcome.Hit, Outcome.Miss, Outcome.Ignored };
        double[] order = { 0.5, 1, 2 };
        Check(Detection.AveragePrecision(PrecisionRule.Voc2010, order, three, 2) == 0.25, "precision");
        double none = Detection.AveragePrecision(PrecisionRule.Coco, new double[0], new Outcome[0], 0);
        Check(double.IsNaN(none), "no truths");
        Refused<ArgumentException>("3 scores need as many outcomes, not 0",
            () => Detection.AveragePrecision(PrecisionRule.Coco, order, new Outcome[0], 1));
    }

    /// <summary>FILE of calls, and how many random calls; or nothing, to see whether the library is new
    /// enough.</summary>
    private static int Main(string[] arguments)
    {
        if (arguments.Length == 0)
        {
            Console.WriteLine(Query.Overlap(Disc, Disc));
            return 0;
        }
        Calls.Test(arguments[0]);
        Refusals();
        PathTests.Test();
        Results();
        PinsAreReleased();
        DisposedDuringCalls();
        OwnStructs();
        ColumnsOfOneArray();
        OverMemory();
        Layouts();
        MeasuresAndBoxes();
        Motions();
        Turns();
        Topologies();
        CapsulesAndRoundedRectangles();
        NothingIsCopied();
        AnyNumberOfThreads(true);
        AnyNumberOfThreads(false);
        Detections(true);
        Detections(false);
        AnyArguments(arguments.Length > 1 ? int.Parse(arguments[1]) : 5000);
        Console.WriteLine("arguments: as they should be");
        return 0;
    }
}
