// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
using System.Runtime.InteropServices;

namespace Vesica
{
    /// <summary>
    /// The six kinds of shapes.
    /// </summary>
    public enum Kind
    {
        /// <summary>
        /// x y
        /// </summary>
        Point = 0,
        /// <summary>
        /// x0 y0 x1 y1
        /// </summary>
        Segment = 1,
        /// <summary>
        /// cx cy r
        /// </summary>
        Circle = 2,
        /// <summary>
        /// min_x min_y max_x max_y
        /// </summary>
        Aabb = 3,
        /// <summary>
        /// cx cy ux uy hx hy
        /// </summary>
        Rect = 4,
        /// <summary>
        /// cx cy ux uy a b
        /// </summary>
        Ellipse = 5,
    }

    /// <summary>
    /// How a shape a relates to a shape b: the eight relations of RCC-8.
    /// </summary>
    public enum Relation : byte
    {
        /// <summary>
        /// a and b have no common point
        /// </summary>
        Disjoint = 0,
        /// <summary>
        /// they have common points, but their insides have none
        /// </summary>
        Touch = 1,
        /// <summary>
        /// their insides meet, and neither shape contains the other
        /// </summary>
        Cross = 2,
        /// <summary>
        /// b contains a, and a has no point of b's outline
        /// </summary>
        Inside = 3,
        /// <summary>
        /// b contains a, and a has points of b's outline
        /// </summary>
        InsideTouch = 4,
        /// <summary>
        /// a contains b, and b has no point of a's outline
        /// </summary>
        Contains = 5,
        /// <summary>
        /// a contains b, and b has points of a's outline
        /// </summary>
        ContainsTouch = 6,
        /// <summary>
        /// a and b are the same set of points
        /// </summary>
        Equal = 7,
    }

    /// <summary>
    /// What makes item a of one index and item b of another a pair of a join.
    /// </summary>
    public enum JoinQuery
    {
        /// <summary>
        /// a and b overlap, as by vesica_overlap_f64
        /// </summary>
        Overlap = 0,
        /// <summary>
        /// their bounds in the indexes do: all pairs that overlap, and some that do not
        /// </summary>
        Bounds = 1,
        /// <summary>
        /// a contains b, as by vesica_contains_f64
        /// </summary>
        Contains = 2,
        /// <summary>
        /// b contains a
        /// </summary>
        Inside = 3,
    }

    /// <summary>
    /// What a shared area is compared with.
    /// </summary>
    public enum Ratio
    {
        /// <summary>
        /// shared area / area of the union of a and b (IoU)
        /// </summary>
        OverUnion = 0,
        /// <summary>
        /// shared area / area of a (IoF)
        /// </summary>
        OverFirst = 1,
        /// <summary>
        /// shared area / area of b (IoA)
        /// </summary>
        OverSecond = 2,
        /// <summary>
        /// shared area / the smaller of the areas (IoS)
        /// </summary>
        OverSmaller = 3,
        /// <summary>
        /// IoU - (area of the hull that neither covers / area of the hull) (GIoU)
        /// </summary>
        Generalized = 4,
        /// <summary>
        /// IoU - (distance of the centres / diagonal of the hull)^2 (DIoU)
        /// </summary>
        Distance = 5,
        /// <summary>
        /// DIoU - v^2 / (1 - IoU + v), v = (difference of angles / 90 degrees)^2 (CIoU)
        /// </summary>
        Complete = 6,
    }

    /// <summary>
    /// How angles are told. They turn from +x towards +y.
    /// </summary>
    public enum Angle
    {
        /// <summary>
        /// radians
        /// </summary>
        Radians = 0,
        /// <summary>
        /// degrees
        /// </summary>
        Degrees = 1,
        /// <summary>
        /// quarter turns
        /// </summary>
        Quarters = 2,
        /// <summary>
        /// added to a unit: angles turn the other way, from +x towards -y
        /// </summary>
        Reversed = 4,
    }

    /// <summary>
    /// How soft suppression lowers scores.
    /// </summary>
    public enum Decay
    {
        /// <summary>
        /// score * (1 - r) if r exceeds the parameter, a threshold from 0 to 1
        /// </summary>
        Linear = 0,
        /// <summary>
        /// score * exp(-r^2 / parameter) if r &gt; 0; the parameter is at least 2^-100
        /// </summary>
        Gaussian = 1,
    }

    /// <summary>
    /// Whether two shapes are at most so far apart.
    /// </summary>
    public enum Within : byte
    {
        /// <summary>
        /// they are farther apart
        /// </summary>
        No = 0,
        /// <summary>
        /// they are at most that far apart
        /// </summary>
        Yes = 1,
        /// <summary>
        /// only with an ellipse: their distance is too close to the one asked for to tell
        /// </summary>
        Nearly = 2,
    }

    /// <summary>
    /// What a cast finds.
    /// </summary>
    public enum Cast
    {
        /// <summary>
        /// no contact from 0 to t_end
        /// </summary>
        Miss = 0,
        /// <summary>
        /// contact, the first after t = 0
        /// </summary>
        Hit = 1,
        /// <summary>
        /// the shapes overlap at t = 0, as vesica_overlap_f64 tells
        /// </summary>
        Start = 2,
        /// <summary>
        /// only from vesica_impact_time_f64: none before t, and perhaps none later
        /// </summary>
        Near = 3,
    }

    /// <summary>
    /// Why the library has no answer.
    /// </summary>
    public enum ErrorCode
    {
        /// <summary>
        /// a pointer is NULL
        /// </summary>
        Null = -1,
        /// <summary>
        /// a shape is invalid; vesica_check_f64 or _f32 says why
        /// </summary>
        Shape = -2,
        /// <summary>
        /// a kind is not one of the six
        /// </summary>
        Kind = -3,
        /// <summary>
        /// another argument is out of its documented range
        /// </summary>
        Argument = -4,
        /// <summary>
        /// a number is NaN or infinite
        /// </summary>
        NotFinite = -5,
        /// <summary>
        /// a radius, half extent or half length is negative
        /// </summary>
        NegativeSize = -6,
        /// <summary>
        /// the axis (ux, uy) is (0, 0)
        /// </summary>
        ZeroAxis = -7,
        /// <summary>
        /// an AABB's min exceeds its max
        /// </summary>
        Inverted = -8,
        /// <summary>
        /// a number of the result would overflow its type
        /// </summary>
        Range = -9,
        /// <summary>
        /// bytes are not an index of this version, or are damaged
        /// </summary>
        Index = -10,
    }

    /// <summary>
    /// A location.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Point : IShape
    {
        /// <summary>x</summary>
        public double X;

        /// <summary>y</summary>
        public double Y;

        /// <summary>From its numbers.</summary>
        public Point(double x, double y)
        {
            X = x;
            Y = y;
        }

        /// <inheritdoc/>
        public Kind Kind { get { return Kind.Point; } }

        /// <inheritdoc/>
        public bool IsDouble { get { return true; } }

        unsafe void IShape.Write(void* numbers)
        {
            var to = (double*)numbers;
            to[0] = X;
            to[1] = Y;
        }
    }

    /// <summary>
    /// All points between two end points. If the two are the same, the segment is a point.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Segment : IShape
    {
        /// <summary>x0</summary>
        public double X0;

        /// <summary>y0</summary>
        public double Y0;

        /// <summary>x1</summary>
        public double X1;

        /// <summary>y1</summary>
        public double Y1;

        /// <summary>From its numbers.</summary>
        public Segment(double x0, double y0, double x1, double y1)
        {
            X0 = x0;
            Y0 = y0;
            X1 = x1;
            Y1 = y1;
        }

        /// <inheritdoc/>
        public Kind Kind { get { return Kind.Segment; } }

        /// <inheritdoc/>
        public bool IsDouble { get { return true; } }

        unsafe void IShape.Write(void* numbers)
        {
            var to = (double*)numbers;
            to[0] = X0;
            to[1] = Y0;
            to[2] = X1;
            to[3] = Y1;
        }
    }

    /// <summary>
    /// A disc: centre and radius, r &gt;= 0.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Circle : IShape
    {
        /// <summary>cx</summary>
        public double CX;

        /// <summary>cy</summary>
        public double CY;

        /// <summary>r</summary>
        public double R;

        /// <summary>From its numbers.</summary>
        public Circle(double cx, double cy, double r)
        {
            CX = cx;
            CY = cy;
            R = r;
        }

        /// <inheritdoc/>
        public Kind Kind { get { return Kind.Circle; } }

        /// <inheritdoc/>
        public bool IsDouble { get { return true; } }

        unsafe void IShape.Write(void* numbers)
        {
            var to = (double*)numbers;
            to[0] = CX;
            to[1] = CY;
            to[2] = R;
        }
    }

    /// <summary>
    /// A box along the coordinate axes, min_x &lt;= max_x and min_y &lt;= max_y.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Aabb : IShape
    {
        /// <summary>min_x</summary>
        public double MinX;

        /// <summary>min_y</summary>
        public double MinY;

        /// <summary>max_x</summary>
        public double MaxX;

        /// <summary>max_y</summary>
        public double MaxY;

        /// <summary>From its numbers.</summary>
        public Aabb(double minX, double minY, double maxX, double maxY)
        {
            MinX = minX;
            MinY = minY;
            MaxX = maxX;
            MaxY = maxY;
        }

        /// <inheritdoc/>
        public Kind Kind { get { return Kind.Aabb; } }

        /// <inheritdoc/>
        public bool IsDouble { get { return true; } }

        unsafe void IShape.Write(void* numbers)
        {
            var to = (double*)numbers;
            to[0] = MinX;
            to[1] = MinY;
            to[2] = MaxX;
            to[3] = MaxY;
        }
    }

    /// <summary>
    /// All points C + s u + t perp(u) with |s| &lt;= hx and |t| &lt;= hy, where C is (cx, cy); hx, hy &gt;= 0 and u !=
    /// (0, 0).
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Rect : IShape
    {
        /// <summary>cx</summary>
        public double CX;

        /// <summary>cy</summary>
        public double CY;

        /// <summary>ux</summary>
        public double UX;

        /// <summary>uy</summary>
        public double UY;

        /// <summary>hx</summary>
        public double HX;

        /// <summary>hy</summary>
        public double HY;

        /// <summary>From its numbers.</summary>
        public Rect(double cx, double cy, double ux, double uy, double hx, double hy)
        {
            CX = cx;
            CY = cy;
            UX = ux;
            UY = uy;
            HX = hx;
            HY = hy;
        }

        /// <inheritdoc/>
        public Kind Kind { get { return Kind.Rect; } }

        /// <inheritdoc/>
        public bool IsDouble { get { return true; } }

        unsafe void IShape.Write(void* numbers)
        {
            var to = (double*)numbers;
            to[0] = CX;
            to[1] = CY;
            to[2] = UX;
            to[3] = UY;
            to[4] = HX;
            to[5] = HY;
        }
    }

    /// <summary>
    /// All points C + s u + t perp(u) with (s/a)^2 + (t/b)^2 &lt;= 1, where C is (cx, cy); a, b &gt;= 0 and u != (0,
    /// 0).
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Ellipse : IShape
    {
        /// <summary>cx</summary>
        public double CX;

        /// <summary>cy</summary>
        public double CY;

        /// <summary>ux</summary>
        public double UX;

        /// <summary>uy</summary>
        public double UY;

        /// <summary>a</summary>
        public double A;

        /// <summary>b</summary>
        public double B;

        /// <summary>From its numbers.</summary>
        public Ellipse(double cx, double cy, double ux, double uy, double a, double b)
        {
            CX = cx;
            CY = cy;
            UX = ux;
            UY = uy;
            A = a;
            B = b;
        }

        /// <inheritdoc/>
        public Kind Kind { get { return Kind.Ellipse; } }

        /// <inheritdoc/>
        public bool IsDouble { get { return true; } }

        unsafe void IShape.Write(void* numbers)
        {
            var to = (double*)numbers;
            to[0] = CX;
            to[1] = CY;
            to[2] = UX;
            to[3] = UY;
            to[4] = A;
            to[5] = B;
        }
    }

    /// <summary>
    /// A distance, and two points that are that far apart: (ax, ay) of shape a and (bx, by) of shape b.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct ClosestPoints
    {
        /// <summary>distance</summary>
        public double Distance;

        /// <summary>ax</summary>
        public double AX;

        /// <summary>ay</summary>
        public double AY;

        /// <summary>bx</summary>
        public double BX;

        /// <summary>by</summary>
        public double BY;

        /// <summary>From its numbers.</summary>
        public ClosestPoints(double distance, double ax, double ay, double bx, double by)
        {
            Distance = distance;
            AX = ax;
            AY = ay;
            BX = bx;
            BY = by;
        }
    }

    /// <summary>
    /// The shortest move of b that ends its overlap with a: its length, and its unit direction (x, y).
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Penetration
    {
        /// <summary>depth</summary>
        public double Depth;

        /// <summary>x</summary>
        public double X;

        /// <summary>y</summary>
        public double Y;

        /// <summary>From its numbers.</summary>
        public Penetration(double depth, double x, double y)
        {
            Depth = depth;
            X = x;
            Y = y;
        }
    }

    /// <summary>
    /// A location.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct PointF : IShape
    {
        /// <summary>x</summary>
        public float X;

        /// <summary>y</summary>
        public float Y;

        /// <summary>From its numbers.</summary>
        public PointF(float x, float y)
        {
            X = x;
            Y = y;
        }

        /// <inheritdoc/>
        public Kind Kind { get { return Kind.Point; } }

        /// <inheritdoc/>
        public bool IsDouble { get { return false; } }

        unsafe void IShape.Write(void* numbers)
        {
            var to = (float*)numbers;
            to[0] = X;
            to[1] = Y;
        }
    }

    /// <summary>
    /// All points between two end points. If the two are the same, the segment is a point.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct SegmentF : IShape
    {
        /// <summary>x0</summary>
        public float X0;

        /// <summary>y0</summary>
        public float Y0;

        /// <summary>x1</summary>
        public float X1;

        /// <summary>y1</summary>
        public float Y1;

        /// <summary>From its numbers.</summary>
        public SegmentF(float x0, float y0, float x1, float y1)
        {
            X0 = x0;
            Y0 = y0;
            X1 = x1;
            Y1 = y1;
        }

        /// <inheritdoc/>
        public Kind Kind { get { return Kind.Segment; } }

        /// <inheritdoc/>
        public bool IsDouble { get { return false; } }

        unsafe void IShape.Write(void* numbers)
        {
            var to = (float*)numbers;
            to[0] = X0;
            to[1] = Y0;
            to[2] = X1;
            to[3] = Y1;
        }
    }

    /// <summary>
    /// A disc: centre and radius, r &gt;= 0.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct CircleF : IShape
    {
        /// <summary>cx</summary>
        public float CX;

        /// <summary>cy</summary>
        public float CY;

        /// <summary>r</summary>
        public float R;

        /// <summary>From its numbers.</summary>
        public CircleF(float cx, float cy, float r)
        {
            CX = cx;
            CY = cy;
            R = r;
        }

        /// <inheritdoc/>
        public Kind Kind { get { return Kind.Circle; } }

        /// <inheritdoc/>
        public bool IsDouble { get { return false; } }

        unsafe void IShape.Write(void* numbers)
        {
            var to = (float*)numbers;
            to[0] = CX;
            to[1] = CY;
            to[2] = R;
        }
    }

    /// <summary>
    /// A box along the coordinate axes, min_x &lt;= max_x and min_y &lt;= max_y.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct AabbF : IShape
    {
        /// <summary>min_x</summary>
        public float MinX;

        /// <summary>min_y</summary>
        public float MinY;

        /// <summary>max_x</summary>
        public float MaxX;

        /// <summary>max_y</summary>
        public float MaxY;

        /// <summary>From its numbers.</summary>
        public AabbF(float minX, float minY, float maxX, float maxY)
        {
            MinX = minX;
            MinY = minY;
            MaxX = maxX;
            MaxY = maxY;
        }

        /// <inheritdoc/>
        public Kind Kind { get { return Kind.Aabb; } }

        /// <inheritdoc/>
        public bool IsDouble { get { return false; } }

        unsafe void IShape.Write(void* numbers)
        {
            var to = (float*)numbers;
            to[0] = MinX;
            to[1] = MinY;
            to[2] = MaxX;
            to[3] = MaxY;
        }
    }

    /// <summary>
    /// All points C + s u + t perp(u) with |s| &lt;= hx and |t| &lt;= hy, where C is (cx, cy); hx, hy &gt;= 0 and u !=
    /// (0, 0).
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct RectF : IShape
    {
        /// <summary>cx</summary>
        public float CX;

        /// <summary>cy</summary>
        public float CY;

        /// <summary>ux</summary>
        public float UX;

        /// <summary>uy</summary>
        public float UY;

        /// <summary>hx</summary>
        public float HX;

        /// <summary>hy</summary>
        public float HY;

        /// <summary>From its numbers.</summary>
        public RectF(float cx, float cy, float ux, float uy, float hx, float hy)
        {
            CX = cx;
            CY = cy;
            UX = ux;
            UY = uy;
            HX = hx;
            HY = hy;
        }

        /// <inheritdoc/>
        public Kind Kind { get { return Kind.Rect; } }

        /// <inheritdoc/>
        public bool IsDouble { get { return false; } }

        unsafe void IShape.Write(void* numbers)
        {
            var to = (float*)numbers;
            to[0] = CX;
            to[1] = CY;
            to[2] = UX;
            to[3] = UY;
            to[4] = HX;
            to[5] = HY;
        }
    }

    /// <summary>
    /// All points C + s u + t perp(u) with (s/a)^2 + (t/b)^2 &lt;= 1, where C is (cx, cy); a, b &gt;= 0 and u != (0,
    /// 0).
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct EllipseF : IShape
    {
        /// <summary>cx</summary>
        public float CX;

        /// <summary>cy</summary>
        public float CY;

        /// <summary>ux</summary>
        public float UX;

        /// <summary>uy</summary>
        public float UY;

        /// <summary>a</summary>
        public float A;

        /// <summary>b</summary>
        public float B;

        /// <summary>From its numbers.</summary>
        public EllipseF(float cx, float cy, float ux, float uy, float a, float b)
        {
            CX = cx;
            CY = cy;
            UX = ux;
            UY = uy;
            A = a;
            B = b;
        }

        /// <inheritdoc/>
        public Kind Kind { get { return Kind.Ellipse; } }

        /// <inheritdoc/>
        public bool IsDouble { get { return false; } }

        unsafe void IShape.Write(void* numbers)
        {
            var to = (float*)numbers;
            to[0] = CX;
            to[1] = CY;
            to[2] = UX;
            to[3] = UY;
            to[4] = A;
            to[5] = B;
        }
    }

    /// <summary>
    /// A distance, and two points that are that far apart: (ax, ay) of shape a and (bx, by) of shape b.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct ClosestPointsF
    {
        /// <summary>distance</summary>
        public float Distance;

        /// <summary>ax</summary>
        public float AX;

        /// <summary>ay</summary>
        public float AY;

        /// <summary>bx</summary>
        public float BX;

        /// <summary>by</summary>
        public float BY;

        /// <summary>From its numbers.</summary>
        public ClosestPointsF(float distance, float ax, float ay, float bx, float by)
        {
            Distance = distance;
            AX = ax;
            AY = ay;
            BX = bx;
            BY = by;
        }
    }

    /// <summary>
    /// The shortest move of b that ends its overlap with a: its length, and its unit direction (x, y).
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct PenetrationF
    {
        /// <summary>depth</summary>
        public float Depth;

        /// <summary>x</summary>
        public float X;

        /// <summary>y</summary>
        public float Y;

        /// <summary>From its numbers.</summary>
        public PenetrationF(float depth, float x, float y)
        {
            Depth = depth;
            X = x;
            Y = y;
        }
    }

    /// <summary>
    /// <para>A first contact: its time t, its point (x, y), and the unit normal (nx, ny) there, from a to b.</para>
    /// <para>After a miss t is infinity and all other numbers are NaN.</para>
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Impact
    {
        /// <summary>t</summary>
        public double T;

        /// <summary>x</summary>
        public double X;

        /// <summary>y</summary>
        public double Y;

        /// <summary>nx</summary>
        public double NX;

        /// <summary>ny</summary>
        public double NY;

        /// <summary>From its numbers.</summary>
        public Impact(double t, double x, double y, double nx, double ny)
        {
            T = t;
            X = x;
            Y = y;
            NX = nx;
            NY = ny;
        }
    }

    /// <summary>
    /// How a shape moves while t runs from 0 to 1: the way (vx, vy) of its centre, and the angle in radians by which it
    /// turns about its centre. Positive angles turn counter-clockwise if y points up.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Turn
    {
        /// <summary>vx</summary>
        public double VX;

        /// <summary>vy</summary>
        public double VY;

        /// <summary>angle</summary>
        public double Angle;

        /// <summary>From its numbers.</summary>
        public Turn(double vx, double vy, double angle)
        {
            VX = vx;
            VY = vy;
            Angle = angle;
        }
    }

    /// <summary>
    /// <para>A first contact: its time t, its point (x, y), and the unit normal (nx, ny) there, from a to b.</para>
    /// <para>After a miss t is infinity and all other numbers are NaN.</para>
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct ImpactF
    {
        /// <summary>t</summary>
        public float T;

        /// <summary>x</summary>
        public float X;

        /// <summary>y</summary>
        public float Y;

        /// <summary>nx</summary>
        public float NX;

        /// <summary>ny</summary>
        public float NY;

        /// <summary>From its numbers.</summary>
        public ImpactF(float t, float x, float y, float nx, float ny)
        {
            T = t;
            X = x;
            Y = y;
            NX = nx;
            NY = ny;
        }
    }

    /// <summary>
    /// How a shape moves while t runs from 0 to 1: the way (vx, vy) of its centre, and the angle in radians by which it
    /// turns about its centre. Positive angles turn counter-clockwise if y points up.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct TurnF
    {
        /// <summary>vx</summary>
        public float VX;

        /// <summary>vy</summary>
        public float VY;

        /// <summary>angle</summary>
        public float Angle;

        /// <summary>From its numbers.</summary>
        public TurnF(float vx, float vy, float angle)
        {
            VX = vx;
            VY = vy;
            Angle = angle;
        }
    }
}
