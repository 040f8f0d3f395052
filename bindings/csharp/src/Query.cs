// SPDX-License-Identifier: Apache-2.0
using System;

namespace Vesica
{
    /// <summary>
    /// Exact overlap queries between plain 2D shapes.
    /// <para>Shapes are closed and solid, and touching is overlap. Answers that are yes or no are exact for every valid
    /// input. An invalid shape is a VesicaException; in a batch all other answers are written all the same. All methods
    /// may be called by several threads at once.</para>
    /// </summary>
    public static unsafe partial class Query
    {
        internal const int MostNumbers = 7;

        private delegate int Codes(bool wide, int kindA, void* a, int kindB, void* b);

        internal delegate int Measures(bool wide, int kindA, void* a, int kindB, void* b, void* output);

        // Made once: a delegate of a static method is slow to make.
        private static readonly Codes overlap = Native.Overlap, relation = Native.Relation, contains = Native.Contains;
        private static readonly Codes interiorsOverlap = Native.InteriorsOverlap;
        private static readonly Measures nearest = Native.Nearest, depth = Native.Depth;
        private static readonly Measures boundaryDistance = Native.BoundaryDistance, area = Native.Area;
        private static readonly Measures iou = Native.Iou;

        private static int Code<A, B>(Codes function, A a, B b) where A : IShape where B : IShape
        {
            double* numbersA = stackalloc double[MostNumbers], numbersB = stackalloc double[MostNumbers];
            bool wide = Write(a, b, numbersA, numbersB);
            return (int)Native.Checked(function(wide, (int)a.Kind, numbersA, (int)b.Kind, numbersB));
        }

        internal static bool Measure<A, B>(Measures function, A a, B b, void* output) where A : IShape where B : IShape
        {
            double* numbersA = stackalloc double[MostNumbers], numbersB = stackalloc double[MostNumbers];
            bool wide = Write(a, b, numbersA, numbersB);
            Native.Checked(function(wide, (int)a.Kind, numbersA, (int)b.Kind, numbersB, output));
            return wide;
        }

        internal delegate long PointQuery(bool wide, int kindA, void* a, int kindB, void* b, void* output,
            long capacity);

        /// <summary>The points that a function of two shapes writes. It is asked again if they are more than 8, as only
        /// those of polygons and polylines are.</summary>
        internal static Point[] PointsOf<A, B>(A a, B b, PointQuery function) where A : IShape where B : IShape
        {
            const int Most = 12;
            double* n = stackalloc double[2 * Most];
            double* numbersA = stackalloc double[MostNumbers], numbersB = stackalloc double[MostNumbers];
            bool wide = Write(a, b, numbersA, numbersB);
            var points = new Point[Native.Checked(function(wide, (int)a.Kind, numbersA, (int)b.Kind, numbersB, n,
                Most))];
            fixed (double* more = points.Length > Most ? new double[2 * points.Length] : null)
            {
                if (more != null)
                    Native.Checked(function(wide, (int)a.Kind, numbersA, (int)b.Kind, numbersB, more, points.Length));
                double* all = more != null ? more : n;
                for (int i = 0; i < points.Length; ++i)
                    points[i] = new Point(At(wide, all, 2 * i), At(wide, all, 2 * i + 1));
            }
            return points;
        }

        private static bool Write<A, B>(A a, B b, void* numbersA, void* numbersB) where A : IShape where B : IShape
        {
            Alike(a.IsDouble, b.IsDouble);
            a.Write(numbersA);
            b.Write(numbersB);
            return a.IsDouble;
        }

        internal static void Alike(bool a, bool b)
        {
            if (a != b) throw new ArgumentException("one has double numbers and one float: convert one of them");
        }

        internal static double At(bool wide, double* numbers, int i)
        {
            return wide ? numbers[i] : ((float*)numbers)[i];
        }

        /// <summary>Do two shapes share a point? Touching counts. Exact.</summary>
        public static bool Overlap<A, B>(A a, B b) where A : IShape where B : IShape
        {
            return Code(overlap, a, b) == 1;
        }

        /// <summary>Do the insides of two shapes share a point? Touching does not count. Exact.</summary>
        public static bool InteriorsOverlap<A, B>(A a, B b) where A : IShape where B : IShape
        {
            return Code(interiorsOverlap, a, b) == 1;
        }

        /// <summary>How does a relate to b? Exact.</summary>
        public static Relation Relation<A, B>(A a, B b) where A : IShape where B : IShape
        {
            return (Relation)Code(relation, a, b);
        }

        /// <summary>Does a hold all of b? Equal shapes do. Exact.</summary>
        public static bool Contains<A, B>(A a, B b) where A : IShape where B : IShape
        {
            return Code(contains, a, b) == 1;
        }

        private static ClosestPoints Closest<A, B>(Measures function, A a, B b) where A : IShape where B : IShape
        {
            double* n = stackalloc double[5];
            bool wide = Measure(function, a, b, n);
            return new ClosestPoints(At(wide, n, 0), At(wide, n, 1), At(wide, n, 2), At(wide, n, 3), At(wide, n, 4));
        }

        /// <summary>How far are the solid shapes apart, and which of their points are closest?</summary>
        public static ClosestPoints Nearest<A, B>(A a, B b) where A : IShape where B : IShape
        {
            return Closest(nearest, a, b);
        }

        /// <summary>How far are the outlines apart, that of a shape inside another too?</summary>
        public static ClosestPoints BoundaryDistance<A, B>(A a, B b) where A : IShape where B : IShape
        {
            return Closest(boundaryDistance, a, b);
        }

        /// <summary>How far and in which direction must b move until it only touches a?</summary>
        public static Penetration Depth<A, B>(A a, B b) where A : IShape where B : IShape
        {
            double* n = stackalloc double[3];
            bool wide = Measure(depth, a, b, n);
            return new Penetration(At(wide, n, 0), At(wide, n, 1), At(wide, n, 2));
        }

        /// <summary>The area that a and b share.</summary>
        public static double Area<A, B>(A a, B b) where A : IShape where B : IShape
        {
            double n;
            return At(Measure(area, a, b, &n), &n, 0);
        }

        /// <summary>Intersection over union, from 0 to 1.</summary>
        public static double Iou<A, B>(A a, B b) where A : IShape where B : IShape
        {
            double n;
            return At(Measure(iou, a, b, &n), &n, 0);
        }

        /// <summary>The places where the outlines meet, in order along a's. Their number is exact. shared tells whether
        /// they have a stretch in common.</summary>
        public static Point[] Crossings<A, B>(A a, B b, out bool shared) where A : IShape where B : IShape
        {
            int stretch = 0;
            int* to = &stretch;
            Point[] places = PointsOf(a, b, (wide, kindA, p, kindB, q, output, capacity) =>
                Native.Crossings(wide, kindA, p, kindB, q, output, capacity, to));
            shared = stretch != 0;
            return places;
        }

        /// <summary>Throws, with the first rule that it breaks, if a shape is invalid.</summary>
        public static void Check<S>(S shape) where S : IShape
        {
            double* numbers = stackalloc double[MostNumbers];
            shape.Write(numbers);
            Native.Checked(Native.Check(shape.IsDouble, (int)shape.Kind, numbers));
        }

        /// <summary>The area of one shape.</summary>
        public static double ShapeArea<S>(S shape) where S : IShape
        {
            double n;
            double* numbers = stackalloc double[MostNumbers];
            shape.Write(numbers);
            Native.Checked(Native.ShapeArea(shape.IsDouble, (int)shape.Kind, numbers, &n));
            return At(shape.IsDouble, &n, 0);
        }

        /// <summary>The smallest box of representable numbers, of the shape's type, that contains it.</summary>
        public static Aabb Bounds<S>(S shape) where S : IShape
        {
            double* n = stackalloc double[4], numbers = stackalloc double[MostNumbers];
            shape.Write(numbers);
            Native.Checked(Native.Bounds(shape.IsDouble, (int)shape.Kind, numbers, n));
            bool wide = shape.IsDouble;
            return new Aabb(At(wide, n, 0), At(wide, n, 1), At(wide, n, 2), At(wide, n, 3));
        }
    }

    /// <summary>Shapes from other descriptions.</summary>
    public static unsafe class Make
    {
        /// <summary>Box with two opposite corners, in any order.</summary>
        public static Aabb Aabb(double x0, double y0, double x1, double y1)
        {
            Aabb made;
            Native.Checked(Native.vesica_aabb_from_corners_f64(x0, y0, x1, y1, &made));
            return made;
        }

        /// <summary>Rectangle from centre, angle in radians, and whole sizes: width along it, height across.</summary>
        public static Rect Rect(double cx, double cy, double angle, double width, double height)
        {
            Rect made;
            Native.Checked(Native.vesica_rect_from_angle_f64(cx, cy, angle, width, height, &made));
            return made;
        }

        /// <summary>Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline. Crossed corners are
        /// refused.</summary>
        public static Rect RectFromCorners(params double[] corners)
        {
            if (corners == null || corners.Length != 8) throw new ArgumentException("four corners have 8 numbers");
            Rect made;
            fixed (double* numbers = corners) Native.Checked(Native.vesica_rect_from_corners_f64(numbers, &made));
            return made;
        }

        /// <summary>The largest distance from a given corner to the rectangle's corner that corresponds to
        /// it.</summary>
        public static double RectCornersMisfit(double[] corners, Rect rect)
        {
            if (corners == null || corners.Length != 8) throw new ArgumentException("four corners have 8 numbers");
            double misfit;
            fixed (double* numbers = corners)
                Native.Checked(Native.vesica_rect_corners_misfit_f64(numbers, &rect, &misfit));
            return misfit;
        }

        /// <summary>Rounded rectangle from centre, angle in radians, whole sizes with the round corners included, and
        /// their radius. A radius of more than half the width or height is refused.</summary>
        public static RoundRect RoundRect(
            double cx, double cy, double angle, double width, double height, double radius)
        {
            RoundRect made;
            Native.Checked(Native.vesica_round_rect_from_angle_f64(cx, cy, angle, width, height, radius, &made));
            return made;
        }

        /// <summary>Capsule from centre, angle in radians, the length between the ends of its segment, and
        /// radius.</summary>
        public static Capsule Capsule(double cx, double cy, double angle, double length, double radius)
        {
            Capsule made;
            Native.Checked(Native.vesica_capsule_from_angle_f64(cx, cy, angle, length, radius, &made));
            return made;
        }

        /// <summary>Capsule from the ends of its segment and its whole width, twice the radius.</summary>
        public static Capsule CapsuleFromWidth(double x0, double y0, double x1, double y1, double width)
        {
            Capsule made;
            Native.Checked(Native.vesica_capsule_from_width_f64(x0, y0, x1, y1, width, &made));
            return made;
        }

        /// <summary>Ellipse from centre, angle in radians, and half lengths: a along the angle, b across.</summary>
        public static Ellipse Ellipse(double cx, double cy, double angle, double a, double b)
        {
            Ellipse made;
            Native.Checked(Native.vesica_ellipse_from_angle_f64(cx, cy, angle, a, b, &made));
            return made;
        }

        /// <summary>One half axis is (wx, wy), the other ratio times its perpendicular.</summary>
        public static Ellipse EllipseFromRadiusVector(double cx, double cy, double wx, double wy, double ratio)
        {
            Ellipse made;
            Native.Checked(Native.vesica_ellipse_from_radius_vector_f64(cx, cy, wx, wy, ratio, &made));
            return made;
        }

        /// <summary>Ellipse of the points within k standard deviations of a mean.</summary>
        public static Ellipse EllipseFromCovariance(
            double meanX, double meanY, double cxx, double cxy, double cyy, double k)
        {
            Ellipse made;
            Native.Checked(Native.vesica_ellipse_from_covariance_f64(meanX, meanY, cxx, cxy, cyy, k, &made));
            return made;
        }

        /// <summary>Ellipse of the points X with (X - C) . M (X - C) at most 1.</summary>
        public static Ellipse EllipseFromMatrix(double cx, double cy, double mxx, double mxy, double myy)
        {
            Ellipse made;
            Native.Checked(Native.vesica_ellipse_from_matrix_f64(cx, cy, mxx, mxy, myy, &made));
            return made;
        }
    }
}
