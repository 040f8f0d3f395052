// SPDX-License-Identifier: Apache-2.0
using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Vesica;

/// <summary>The calls that all packages answer alike (bindings/calls/calls.txt), and that wrong answers are found.</summary>
internal sealed unsafe class Calls
{
    private static readonly string[] Kinds = { "point", "segment", "circle", "aabb", "rect", "ellipse" };

    private static readonly string[] Motions = { "sweep_bounds", "impact_time" };

    private static readonly string[] Topologies =
        { "de9im", "de9im_match", "intersection", "join_within", "suppress_soft" };

    private readonly string function;
    private readonly bool wide;
    private readonly string[] arguments;
    private double[] values = new double[0];

    private Calls(string function, bool wide, string[] arguments)
    {
        this.function = function;
        this.wide = wide;
        this.arguments = arguments;
    }

    private static double PowerOfTwo(int exponent)
    {
        bool isTiny = exponent < -1022;
        return BitConverter.Int64BitsToDouble(isTiny ? 1L << (exponent + 1074) : (long)(exponent + 1023) << 52);
    }

    /// <summary>A hexadecimal float of C's, or a decimal number.</summary>
    private static double Number(string word)
    {
        if (word.EndsWith("nan")) return double.NaN;
        if (word.EndsWith("inf")) return word[0] == '-' ? double.NegativeInfinity : double.PositiveInfinity;
        int sign = word[0] == '-' ? -1 : 1;
        string digits = word.TrimStart('-');
        if (!digits.StartsWith("0x")) return double.Parse(word, CultureInfo.InvariantCulture);
        string[] parts = digits.Substring(2).Split('p'), mantissa = parts[0].Split('.');
        string fraction = mantissa.Length > 1 ? mantissa[1] : "";
        long bits = long.Parse(mantissa[0] + fraction, NumberStyles.HexNumber);
        // Of 0 the sign remains.
        return sign * (double)bits * PowerOfTwo(int.Parse(parts[1],
            NumberStyles.AllowLeadingSign) - 4 * fraction.Length);
    }

    private static IEnumerable<string> Words(string argument)
    {
        return argument.Split(new[] { ' ' }, StringSplitOptions.RemoveEmptyEntries);
    }

    private static double[] Numbers(string argument)
    {
        return Words(argument).Where(word => !Kinds.Contains(word)).Select(Number).ToArray();
    }

    private static float[] Narrow(double[] numbers)
    {
        return numbers.Select(number => (float)number).ToArray();
    }

    private static Kind KindOf(string argument)
    {
        return (Kind)Array.IndexOf(Kinds, Words(argument).First());
    }

    private Shapes ShapesOf(string argument)
    {
        double[] numbers = Numbers(argument);
        return wide ? Shapes.Of(KindOf(argument), numbers) : Shapes.Of(KindOf(argument), Narrow(numbers));
    }

    private AnyShape Single(string argument)
    {
        return new AnyShape(KindOf(argument), wide, Numbers(argument));
    }

    private long Gives(params double[] numbers)
    {
        values = numbers;
        return 0;
    }

    private long Gives(ClosestPoints p)
    {
        return Gives(p.Distance, p.AX, p.AY, p.BX, p.BY);
    }

    private long OfOneOrTwo()
    {
        AnyShape a = Single(arguments[0]), b = Single(arguments.Last());
        switch (function)
        {
            case "overlap": return Query.Overlap(a, b) ? 1 : 0;
            case "interiors_overlap": return Query.InteriorsOverlap(a, b) ? 1 : 0;
            case "relation": return (long)Query.Relation(a, b);
            case "contains": return Query.Contains(a, b) ? 1 : 0;
            case "nearest": return Gives(Query.Nearest(a, b));
            case "boundary_distance": return Gives(Query.BoundaryDistance(a, b));
            case "signed_distance": return Gives(Distances.Signed(a, b));
            case "area": return Gives(Query.Area(a, b));
            case "iou": return Gives(Query.Iou(a, b));
            case "shape_area": return Gives(Query.ShapeArea(a));
            case "depth":
                Penetration depth = Query.Depth(a, b);
                return Gives(depth.Depth, depth.X, depth.Y);
            case "check":
                Query.Check(a);
                return 0;
            case "bounds":
                Aabb box = Query.Bounds(a);
                return Gives(box.MinX, box.MinY, box.MaxX, box.MaxY);
            case "crossings":
                bool shared;
                Point[] places = Query.Crossings(a, b, out shared);
                values = new double[] { shared ? 1 : 0 }.Concat(places.SelectMany(p => new[] { p.X, p.Y })).ToArray();
                return places.Length;
            default: throw new InvalidOperationException(function);
        }
    }

    private long Gives(IShape shape, int count)
    {
        double* numbers = stackalloc double[7];
        shape.Write(numbers);
        values = new double[count];
        for (int i = 0; i < count; ++i) values[i] = shape.IsDouble ? numbers[i] : ((float*)numbers)[i];
        return 0;
    }

    private long Misfit()
    {
        double[] corners = Numbers(arguments[0]), r = Numbers(arguments[1]);
        if (wide)
        {
            values = new[] { Make.RectCornersMisfit(corners, new Rect(r[0], r[1], r[2], r[3], r[4], r[5])) };
            return 0;
        }
        float misfit;
        fixed (float* numbers = Narrow(corners), rect = Narrow(r))
            Native.Checked(Native.vesica_rect_corners_misfit_f32(numbers, rect, &misfit));
        values = new double[] { misfit };
        return 0;
    }

    private long Constructed()
    {
        double[] n = Numbers(arguments[0]);
        if (!wide) return ConstructedInFloat(Narrow(n));
        switch (function)
        {
            case "aabb_from_corners": return Gives(Make.Aabb(n[0], n[1], n[2], n[3]), 4);
            case "rect_from_angle": return Gives(Make.Rect(n[0], n[1], n[2], n[3], n[4]), 6);
            case "rect_from_corners": return Gives(Make.RectFromCorners(n), 6);
            case "round_rect_from_angle": return Gives(Make.RoundRect(n[0], n[1], n[2], n[3], n[4], n[5]), 7);
            case "capsule_from_angle": return Gives(Make.Capsule(n[0], n[1], n[2], n[3], n[4]), 5);
            case "capsule_from_width": return Gives(Make.CapsuleFromWidth(n[0], n[1], n[2], n[3], n[4]), 5);
            case "ellipse_from_angle": return Gives(Make.Ellipse(n[0], n[1], n[2], n[3], n[4]), 6);
            case "ellipse_from_radius_vector":
                return Gives(Make.EllipseFromRadiusVector(n[0], n[1], n[2], n[3], n[4]), 6);
            case "ellipse_from_covariance":
                return Gives(Make.EllipseFromCovariance(n[0], n[1], n[2], n[3], n[4], n[5]), 6);
            default: return Gives(Make.EllipseFromMatrix(n[0], n[1], n[2], n[3], n[4]), 6);
        }
    }

    /// <summary>The package makes doubles; the functions in float are there for whom wants them.</summary>
    private long ConstructedInFloat(float[] n)
    {
        var all = new float[7];
        int code;
        fixed (float* numbers = n, made = all)
            switch (function)
            {
                case "aabb_from_corners":
                    code = Native.vesica_aabb_from_corners_f32(n[0], n[1], n[2], n[3], made);
                    break;
                case "rect_from_angle":
                    code = Native.vesica_rect_from_angle_f32(n[0], n[1], n[2], n[3], n[4], made);
                    break;
                case "rect_from_corners": code = Native.vesica_rect_from_corners_f32(numbers, made); break;
                case "round_rect_from_angle":
                    code = Native.vesica_round_rect_from_angle_f32(n[0], n[1], n[2], n[3], n[4], n[5], made);
                    break;
                case "capsule_from_angle":
                    code = Native.vesica_capsule_from_angle_f32(n[0], n[1], n[2], n[3], n[4], made);
                    break;
                case "capsule_from_width":
                    code = Native.vesica_capsule_from_width_f32(n[0], n[1], n[2], n[3], n[4], made);
                    break;
                case "ellipse_from_angle":
                    code = Native.vesica_ellipse_from_angle_f32(n[0], n[1], n[2], n[3], n[4], made);
                    break;
                case "ellipse_from_radius_vector":
                    code = Native.vesica_ellipse_from_radius_vector_f32(n[0], n[1], n[2], n[3], n[4], made);
                    break;
                case "ellipse_from_covariance":
                    code = Native.vesica_ellipse_from_covariance_f32(n[0], n[1], n[2], n[3], n[4], n[5], made);
                    break;
                default: code = Native.vesica_ellipse_from_matrix_f32(n[0], n[1], n[2], n[3], n[4], made); break;
            }
        int count = function.StartsWith("aabb") ? 4 : function.StartsWith("capsule") ? 5
            : function.StartsWith("round_rect") ? 7 : 6;
        values = all.Take(count).Select(number => (double)number).ToArray();
        return Native.Checked(code);
    }

    private static double[] OfBools(bool[] bools)
    {
        return bools.Select(yes => yes ? 1.0 : 0.0).ToArray();
    }

    private static double[] OfItems(IEnumerable<long> items)
    {
        return items.Select(item => (double)item).ToArray();
    }

    private long Rows(int width, Action<double[], float[]> call)
    {
        var count = (int)ShapesOf(arguments[0]).Count * width;
        double[] doubles = new double[count];
        float[] floats = new float[count];
        try
        {
            call(doubles, floats);
        }
        finally
        {
            values = wide ? doubles : floats.Select(number => (double)number).ToArray();
        }
        return 0;
    }

    private void Take(object shapes)
    {
        values = ((Array)shapes).Cast<IShape>().SelectMany(shape => { Gives(shape, 6); return values; }).ToArray();
    }

    private long OfBoxes()
    {
        double[] boxes = function.EndsWith("_from_boxes") ? Numbers(arguments[0]) : null;
        var angle = (Angle)(arguments.Length > 1 ? (int)Number(arguments[1].Trim()) : 0);
        Shapes shapes = boxes == null ? ShapesOf(arguments[0]) : null;
        switch (function)
        {
            case "rects_from_boxes":
                Take(wide ? (object)Boxes.Rects(boxes, angle) : Boxes.Rects(Narrow(boxes), angle));
                return 0;
            case "ellipses_from_boxes":
                Take(wide ? (object)Boxes.Ellipses(boxes, angle) : Boxes.Ellipses(Narrow(boxes), angle));
                return 0;
            case "boxes_from_shapes":
                return Rows(5, (d, f) => { if (wide) Boxes.Of(shapes, angle, d); else Boxes.Of(shapes, angle, f); });
            case "corners_of_shapes":
                return Rows(8, (d, f) => { if (wide) Boxes.Corners(shapes, d); else Boxes.Corners(shapes, f); });
            default:
                return Bounds(shapes);
        }
    }

    private long Bounds(Shapes shapes)
    {
        var boxes = new Aabb[shapes.Count];
        var boxesF = new AabbF[shapes.Count];
        try
        {
            if (wide) Boxes.Bounds(shapes, boxes); else Boxes.Bounds(shapes, boxesF);
        }
        finally
        {
            values = wide ? boxes.SelectMany(b => new[] { b.MinX, b.MinY, b.MaxX, b.MaxY }).ToArray()
                : boxesF.SelectMany(b => new double[] { b.MinX, b.MinY, b.MaxX, b.MaxY }).ToArray();
        }
        return 0;
    }

    private long Gives(long result, Impact i)
    {
        values = new[] { i.T, i.X, i.Y, i.NX, i.NY };
        return result;
    }

    private long First(long item, Impact impact, long count)
    {
        return Gives(item < 0 ? count : item, impact);
    }

    private long CastMany()
    {
        Shapes a = ShapesOf(arguments[0]), b = ShapesOf(arguments[1]);
        double[] vx = Numbers(arguments[2]), vy = Numbers(arguments[3]);
        double end = Numbers(arguments[4])[0];
        long count = Math.Max(a.Count, b.Count);
        double[][] c = Enumerable.Range(0, 5).Select(i => new double[count]).ToArray();
        float[][] f = Enumerable.Range(0, 5).Select(i => new float[count]).ToArray();
        try
        {
            return wide ? Motion.CastMany(a, b, vx, vy, end, c[0], c[1], c[2], c[3], c[4])
                : Motion.CastMany(a, b, Narrow(vx), Narrow(vy), end, f[0], f[1], f[2], f[3], f[4]);
        }
        finally
        {
            values = wide ? c.SelectMany(x => x).ToArray() : f.SelectMany(x => x).Select(x => (double)x).ToArray();
        }
    }

    private static Turn TurnOf(double[] n)
    {
        return new Turn(n[0], n[1], n[2]);
    }

    private long OfTurns()
    {
        Impact impact;
        double gap, tolerance = Numbers(arguments[4])[0];
        Turn turnA = TurnOf(Numbers(arguments[1])), turnB = TurnOf(Numbers(arguments[3]));
        AnyShape a = Single(arguments[0]), b = Single(arguments[2]);
        var found = (long)Motion.ImpactTime(a, turnA, b, turnB, tolerance, out impact, out gap);
        Gives(found, impact);
        values = values.Concat(new[] { gap }).ToArray();
        return found;
    }

    private long OfMotion()
    {
        if (function == "impact_time") return OfTurns();
        if (function == "cast_many") return CastMany();
        double[] n = Numbers(arguments[function == "cast" || function == "cast_first" ? 2 : 1]);
        var motion = new Motion(n[0], n[1], n[2]);
        Impact impact;
        AnyShape one = Single(arguments[0]);
        switch (function)
        {
            case "cast":
                var found = (long)motion.Cast(one, Single(arguments[1]), out impact);
                return Gives(found, impact);
            case "cast_first":
                Shapes many = ShapesOf(arguments[1]);
                long first = motion.CastFirst(one, many, out impact);
                return First(first, impact, many.Count);
            case "sweep_bounds":
                Aabb box = motion.Bounds(one);
                return Gives(box.MinX, box.MinY, box.MaxX, box.MaxY);
        }
        using (var index = new ShapeIndex(arguments.Skip(2).Select(ShapesOf).ToArray()))
        {
            if (function == "index_cast") return Items(index.Cast(one, motion));
            long item = index.CastFirst(one, motion, out impact);
            return First(item, impact, index.Count);
        }
    }

    private long OfRatios()
    {
        var ratio = (Ratio)(int)Number(arguments[0].Trim());
        if (function == "ratio") return Gives(Measures.Ratio(ratio, Single(arguments[1]), Single(arguments[2])));
        Shapes a = ShapesOf(arguments[1]), b = ShapesOf(arguments[2]);
        bool isMatrix = function.EndsWith("_matrix");
        long count = isMatrix ? a.Count * b.Count : Math.Max(a.Count, b.Count);
        double[] d = new double[count];
        float[] f = new float[count];
        try
        {
            if (isMatrix) return wide ? Measures.RatioMatrix(ratio, a, b, d) : Measures.RatioMatrix(ratio, a, b, f);
            return wide ? Measures.RatioMany(ratio, a, b, d) : Measures.RatioMany(ratio, a, b, f);
        }
        finally
        {
            values = wide ? d : f.Select(number => (double)number).ToArray();
        }
    }

    private long OfTopology()
    {
        switch (function)
        {
            case "de9im_match": return Topology.Matches(arguments[0], arguments[1].Trim()) ? 1 : 0;
            case "within": return (long)Distances.Within(Single(arguments[0]), Single(arguments[1]), Distance());
            case "suppress_soft": return Softly();
            case "join_within": return JoinWithin();
            case "de9im":
                string matrix = Topology.De9im(Single(arguments[0]), Single(arguments[1]));
                return Gives(matrix.Select(letter => (double)("F012".IndexOf(letter) - 1)).ToArray());
            case "intersection":
                Point[] vertices = Topology.Intersection(Single(arguments[0]), Single(arguments[1]));
                values = vertices.SelectMany(p => new[] { p.X, p.Y }).ToArray();
                return vertices.Length;
        }
        Shapes a = ShapesOf(arguments[0]), b = ShapesOf(arguments[1]);
        bool isMatrix = function == "within_matrix";
        var near = new Within[isMatrix ? a.Count * b.Count : Math.Max(a.Count, b.Count)];
        try
        {
            if (isMatrix) return Distances.WithinMatrix(a, b, Distance(), near);
            return Distances.WithinMany(a, b, Distance(), near);
        }
        finally
        {
            values = near.Select(each => (double)each).ToArray();
        }
    }

    private double Distance()
    {
        return Numbers(arguments[2])[0];
    }

    private long JoinWithin()
    {
        Shapes[] setsA = arguments.Skip(1).TakeWhile(text => text != "/").Select(ShapesOf).ToArray();
        Shapes[] setsB = arguments.SkipWhile(text => text != "/").Skip(1).Select(ShapesOf).ToArray();
        using (var a = new ShapeIndex(setsA))
        using (ShapeIndex other = setsB.Length > 0 ? new ShapeIndex(setsB) : null)
        {
            Pair[] pairs = a.JoinWithin(other ?? a, Numbers(arguments[0])[0]);
            values = pairs.SelectMany(pair => new double[] { pair.A, pair.B }).ToArray();
            return pairs.Length;
        }
    }

    private long Softly()
    {
        double[] scores = Numbers(arguments[1]), how = Numbers(arguments[2]);
        int[] labels = arguments.Length < 4 ? null : Numbers(arguments[3]).Select(label => (int)label).ToArray();
        var soft = new SoftSuppression((Decay)(int)how[1], how[2])
        {
            Ratio = (Ratio)(int)how[0], Labels = labels, LeastScore = how[3], Most = (long)how[4]
        };
        Shapes shapes = ShapesOf(arguments[0]);
        Take(wide ? Soft.Suppress(shapes, scores, soft) : Soft.Suppress(shapes, Narrow(scores), soft));
        return 0;
    }

    private void Take(Kept[] kept)
    {
        values = kept.Select(each => (double)each.Item).Concat(kept.Select(each => each.Score)).ToArray();
    }

    private long Chosen()
    {
        double[] scores = Numbers(arguments[1]), how = Numbers(arguments[2]);
        int[] labels = arguments.Length < 4 ? null : Numbers(arguments[3]).Select(label => (int)label).ToArray();
        var suppression = new Suppression(how[1])
        {
            Ratio = (Ratio)(int)how[0], Labels = labels, LeastScore = how[2], Most = (long)how[3]
        };
        Shapes shapes = ShapesOf(arguments[0]);
        values = OfItems(wide ? Measures.Suppress(shapes, scores, suppression)
            : Measures.Suppress(shapes, Narrow(scores), suppression));
        return 0;
    }

    private long OfArrays()
    {
        Shapes a = ShapesOf(arguments[0]), b = ShapesOf(arguments[1]);
        var count = (int)(function.EndsWith("_matrix") ? a.Count * b.Count : Math.Max(a.Count, b.Count));
        var yes = new bool[count];
        var relations = new Relation[count];
        try
        {
            switch (function)
            {
                case "overlap_many": return Query.OverlapMany(a, b, yes);
                case "interiors_overlap_many": return Query.InteriorsOverlapMany(a, b, yes);
                case "contains_many": return Query.ContainsMany(a, b, yes);
                case "relation_many": return Query.RelationMany(a, b, relations);
                case "overlap_matrix": return Query.OverlapMatrix(a, b, yes);
                case "interiors_overlap_matrix": return Query.InteriorsOverlapMatrix(a, b, yes);
                case "contains_matrix": return Query.ContainsMatrix(a, b, yes);
                case "relation_matrix": return Query.RelationMatrix(a, b, relations);
                default: return wide ? InDouble(a, b, count) : InFloat(a, b, count);
            }
        }
        finally
        {
            if (function.StartsWith("relation")) values = relations.Select(relation => (double)relation).ToArray();
            else if (function.Contains("overlap") || function.StartsWith("contains")) values = OfBools(yes);
        }
    }

    private int Used()
    {
        bool isOne = new[] { "signed", "area", "iou" }.Any(function.StartsWith) || function.EndsWith("_matrix");
        return function == "depth_many" ? 3 : isOne ? 1 : 5;
    }

    private long InDouble(Shapes a, Shapes b, int count)
    {
        double[][] c = Enumerable.Range(0, 5).Select(i => new double[count]).ToArray();
        int used = Used();
        try
        {
            switch (function)
            {
                case "area_many": return Query.AreaMany(a, b, c[0]);
                case "iou_many": return Query.IouMany(a, b, c[0]);
                case "area_matrix": return Query.AreaMatrix(a, b, c[0]);
                case "iou_matrix": return Query.IouMatrix(a, b, c[0]);
                case "signed_distance_many": return Distances.SignedMany(a, b, c[0]);
                case "signed_distance_matrix": return Distances.SignedMatrix(a, b, c[0]);
                case "nearest_matrix": return Query.NearestMatrix(a, b, c[0]);
                case "boundary_distance_matrix": return Query.BoundaryDistanceMatrix(a, b, c[0]);
                case "depth_matrix": return Query.DepthMatrix(a, b, c[0]);
                case "depth_many": return Query.DepthMany(a, b, c[0], c[1], c[2]);
                case "nearest_many": return Query.NearestMany(a, b, c[0], c[1], c[2], c[3], c[4]);
                case "boundary_distance_many": return Query.BoundaryDistanceMany(a, b, c[0], c[1], c[2], c[3], c[4]);
                default: throw new InvalidOperationException(function);
            }
        }
        finally
        {
            values = c.Take(used).SelectMany(column => column).ToArray();
        }
    }

    private long InFloat(Shapes a, Shapes b, int count)
    {
        float[][] c = Enumerable.Range(0, 5).Select(i => new float[count]).ToArray();
        int used = Used();
        try
        {
            switch (function)
            {
                case "area_many": return Query.AreaMany(a, b, c[0]);
                case "iou_many": return Query.IouMany(a, b, c[0]);
                case "area_matrix": return Query.AreaMatrix(a, b, c[0]);
                case "iou_matrix": return Query.IouMatrix(a, b, c[0]);
                case "signed_distance_many": return Distances.SignedMany(a, b, c[0]);
                case "signed_distance_matrix": return Distances.SignedMatrix(a, b, c[0]);
                case "nearest_matrix": return Query.NearestMatrix(a, b, c[0]);
                case "boundary_distance_matrix": return Query.BoundaryDistanceMatrix(a, b, c[0]);
                case "depth_matrix": return Query.DepthMatrix(a, b, c[0]);
                case "depth_many": return Query.DepthMany(a, b, c[0], c[1], c[2]);
                case "nearest_many": return Query.NearestMany(a, b, c[0], c[1], c[2], c[3], c[4]);
                case "boundary_distance_many": return Query.BoundaryDistanceMany(a, b, c[0], c[1], c[2], c[3], c[4]);
                default: throw new InvalidOperationException(function);
            }
        }
        finally
        {
            values = c.Take(used).SelectMany(column => column.Select(number => (double)number)).ToArray();
        }
    }

    private long Items(long[] items)
    {
        values = OfItems(items);
        return items.Length;
    }

    private long Suppression()
    {
        double[] scores = Numbers(arguments[1]);
        double threshold = Numbers(arguments[2])[0];
        Shapes shapes = ShapesOf(arguments[0]);
        values = OfItems(wide ? Query.Nms(shapes, scores, threshold) : Query.Nms(shapes, Narrow(scores), threshold));
        return 0;
    }

    private void Take(Neighbour[] found)
    {
        values = found.Select(each => (double)each.Item).Concat(found.Select(each => each.Distance)).ToArray();
    }

    private long OfIndexes()
    {
        bool hasOne = function == "index_select" || function.StartsWith("join");
        int leading = function == "index_nearest" ? 2 : hasOne ? 1 : 0;
        string[] rest = arguments.Skip(leading).ToArray();
        Shapes[] setsA = rest.TakeWhile(text => text != "/").Select(ShapesOf).ToArray();
        Shapes[] setsB = rest.SkipWhile(text => text != "/").Skip(1).Select(ShapesOf).ToArray();
        using (var built = new ShapeIndex(setsA))
        using (ShapeIndex a = ShapeIndex.FromBytes(built.ToBytes(), setsA))
        using (ShapeIndex other = setsB.Length > 0 ? new ShapeIndex(setsB) : null)
        {
            ShapeIndex b = other ?? a;
            switch (function)
            {
                case "index_bounds":
                    Aabb box = a.Bounds();
                    return Gives(box.MinX, box.MinY, box.MaxX, box.MaxY);
                case "index_order": return Items(a.Order());
                case "index_select": return Items(a.Select(Single(arguments[0])));
                case "index_nearest":
                    double[] how = Numbers(arguments[1]);
                    Take(a.Nearest(Single(arguments[0]), (int)how[0], how[1]));
                    return values.Length / 2;
                case "join":
                    var query = (JoinQuery)Number(arguments[0]);
                    Pair[] pairs = a.Join(b, query);
                    if (a.JoinCount(b, query) != pairs.Length) throw new InvalidOperationException("another count");
                    values = pairs.SelectMany(pair => new double[] { pair.A, pair.B }).ToArray();
                    return pairs.Length;
                default:
                    double[] of = Numbers(arguments[0]);
                    Take(b.NearestOfEach((int)of[0], of[1], setsA));
                    return values.Take(values.Length / 2).Count(item => item >= 0);
            }
        }
    }

    private long Answer()
    {
        if (function.Contains("boxes") || function == "corners_of_shapes" ||
            function == "bounds_many") return OfBoxes();
        if (function.Contains("cast") || Motions.Contains(function)) return OfMotion();
        if (function.StartsWith("ratio")) return OfRatios();
        if (function == "suppress") return Chosen();
        if (function.StartsWith("within") || Topologies.Contains(function)) return OfTopology();
        if (function.Contains("_from_")) return Constructed();
        if (function == "rect_corners_misfit") return Misfit();
        if (function == "nms") return Suppression();
        if (function == "overlap_select")
            return Items(Query.OverlapSelect(Single(arguments[0]), ShapesOf(arguments[1])));
        if (function == "interiors_overlap_select")
            return Items(Query.InteriorsOverlapSelect(Single(arguments[0]), ShapesOf(arguments[1])));
        if (function.StartsWith("index_") || function.StartsWith("join")) return OfIndexes();
        if (function.EndsWith("_many") || function.EndsWith("_matrix")) return OfArrays();
        return OfOneOrTwo();
    }

    private static string NameOf(ErrorCode code)
    {
        return "E" + string.Concat(code.ToString().Select(c => char.IsUpper(c) ? "_" + c : c.ToString().ToUpper()));
    }

    private bool Same(double[] expected)
    {
        Func<double, long> bits = number => double.IsNaN(number) ? -1 : BitConverter.DoubleToInt64Bits(number);
        return values.Select(bits).SequenceEqual(expected.Select(bits));
    }

    private static bool IsRight(string line)
    {
        string[] sides = line.Split(new[] { " = " }, StringSplitOptions.None);
        string[] parts = sides[0].Split(new[] { " | " }, StringSplitOptions.None), name = parts[0].Split(' ');
        string[] right = sides[1].Split(' ');
        double[] expected = right.Skip(1).Select(Number).ToArray();
        var call = new Calls(name[0], name[1] == "f64", parts.Skip(1).ToArray());
        try
        {
            return call.Answer().ToString() == right[0] && call.Same(expected);
        }
        catch (VesicaException e)
        {
            if (e.Result is long[]) call.values = OfItems((long[])e.Result);
            if (e.Result is Rect[] || e.Result is Ellipse[]) call.Take(e.Result);
            if (e.Result is RectF[] || e.Result is EllipseF[]) call.Take(e.Result);
            if (e.Result is Kept[]) call.Take((Kept[])e.Result);
            if (e.Result is Neighbour[]) call.Take((Neighbour[])e.Result);
            return right[0] == NameOf(e.Code) && (expected.Length == 0 || call.Same(expected));
        }
    }

    internal static void Test(string file)
    {
        string[] lines = File.ReadLines(file).Where(line => !line.StartsWith("#")).ToArray();
        string[] wrong = lines.Where(line => !IsRight(line)).ToArray();
        if (wrong.Length > 0) throw new InvalidOperationException(string.Join("\n", wrong));
        // The first call of each function, with its last word made what no call gives.
        var functions = new HashSet<string>();
        foreach (string line in lines)
        {
            string spoilt = line.Substring(0, line.LastIndexOf(' ')) + " 7.5";
            if (functions.Add(line.Split(' ')[0]) && IsRight(spoilt))
                throw new InvalidOperationException("taken for right: " + spoilt);
        }
        if (lines.Length < 700 || functions.Count < 70) throw new InvalidOperationException("too few");
        Console.WriteLine(lines.Length + " calls of " + functions.Count + " functions");
    }
}
