// SPDX-License-Identifier: Apache-2.0

package vesica

// AABBFromCorners is the box with two opposite corners, in any order.
func AABBFromCorners[T Float](x0, y0, x1, y1 T) (out AABB[T], err error) {
	code := cAABBFromCorners(isWide[T](), float64(x0), float64(y0), float64(x1), float64(y1), address(&out))
	return out, status(code)
}

// RectFromAngle is a rectangle from centre, angle in radians, and whole sizes: width along the angle, height across it.
func RectFromAngle[T Float](cx, cy, angle, width, height T) (out Rect[T], err error) {
	code := cRectFromAngle(isWide[T](), float64(cx), float64(cy), float64(angle), float64(width), float64(height),
		address(&out))
	return out, status(code)
}

// RectFromCorners is a rectangle from its four corners x0 y0 ... x3 y3, in order round the outline. Crossed corners are
// ErrArgument; RectCornersMisfit says how far the corners are off.
func RectFromCorners[T Float](corners [8]T) (out Rect[T], err error) {
	code := cRectFromCorners(isWide[T](), address(&corners), address(&out))
	return out, status(code)
}

// RectCornersMisfit is the largest distance from a given corner to the rectangle's corner that corresponds to it.
func RectCornersMisfit[T Float](corners [8]T, r Rect[T]) (misfit T, err error) {
	code := cRectCornersMisfit(isWide[T](), address(&corners), address(&r), address(&misfit))
	return misfit, status(code)
}

// RoundRectFromAngle is a rounded rectangle from centre, angle in radians, whole sizes with the round corners included,
// and their radius. A radius of more than half the width or height is ErrArgument.
func RoundRectFromAngle[T Float](cx, cy, angle, width, height, radius T) (out RoundRect[T], err error) {
	code := cRoundRectFromAngle(isWide[T](), float64(cx), float64(cy), float64(angle), float64(width), float64(height),
		float64(radius), address(&out))
	return out, status(code)
}

// CapsuleFromAngle is a capsule from centre, angle in radians, the length between the ends of its segment, and radius.
func CapsuleFromAngle[T Float](cx, cy, angle, length, radius T) (out Capsule[T], err error) {
	code := cCapsuleFromAngle(isWide[T](), float64(cx), float64(cy), float64(angle), float64(length), float64(radius),
		address(&out))
	return out, status(code)
}

// CapsuleFromWidth is a capsule from the ends of its segment and its whole width, twice the radius.
func CapsuleFromWidth[T Float](x0, y0, x1, y1, width T) (out Capsule[T], err error) {
	code := cCapsuleFromWidth(isWide[T](), float64(x0), float64(y0), float64(x1), float64(y1), float64(width),
		address(&out))
	return out, status(code)
}

// EllipseFromAngle is an ellipse from centre, angle in radians, and half lengths: a along the angle, b across it.
func EllipseFromAngle[T Float](cx, cy, angle, a, b T) (out Ellipse[T], err error) {
	code := cEllipseFromAngle(isWide[T](), float64(cx), float64(cy), float64(angle), float64(a), float64(b),
		address(&out))
	return out, status(code)
}

// EllipseFromRadiusVector has one half axis (wx, wy), and the other is ratio times its perpendicular.
func EllipseFromRadiusVector[T Float](cx, cy, wx, wy, ratio T) (out Ellipse[T], err error) {
	code := cEllipseFromRadiusVector(isWide[T](), float64(cx), float64(cy), float64(wx), float64(wy), float64(ratio),
		address(&out))
	return out, status(code)
}

// EllipseFromCovariance has the points within k standard deviations of a mean.
func EllipseFromCovariance[T Float](meanX, meanY, cxx, cxy, cyy, k T) (out Ellipse[T], err error) {
	code := cEllipseFromCovariance(isWide[T](), float64(meanX), float64(meanY), float64(cxx), float64(cxy),
		float64(cyy), float64(k), address(&out))
	return out, status(code)
}

// EllipseFromMatrix has the points X with (X - C) . M (X - C) <= 1.
func EllipseFromMatrix[T Float](cx, cy, mxx, mxy, myy T) (out Ellipse[T], err error) {
	code := cEllipseFromMatrix(isWide[T](), float64(cx), float64(cy), float64(mxx), float64(mxy), float64(myy),
		address(&out))
	return out, status(code)
}
