// SPDX-License-Identifier: Apache-2.0

// Package vesica answers exact overlap queries between plain 2D shapes. Touching counts.
package vesica

/*
#cgo pkg-config: vesica
#include <vesica.h>

// Go memory that holds pointers to Go memory must not be passed to C, so the views of the slices are made here.
static int64_t overlap_many(int32_t kind_a, int64_t count_a, const void *a, ptrdiff_t size_a, int32_t kind_b,
                            int64_t count_b, const void *b, ptrdiff_t size_b, uint8_t *out) {
  vesica_shapes_f64 shapes_a, shapes_b;
  int32_t error = vesica_shapes_from_records_f64(kind_a, count_a, a, size_a, &shapes_a);
  if (error == 0) error = vesica_shapes_from_records_f64(kind_b, count_b, b, size_b, &shapes_b);
  return error != 0 ? error : vesica_overlap_many_f64(&shapes_a, &shapes_b, out);
}
*/
import "C"

import (
	"fmt"
	"unsafe"
)

// The shapes, laid out as the library's structs. Axes are the cosine and sine of the angle.
type (
	Point   struct{ X, Y float64 }
	Segment struct{ X0, Y0, X1, Y1 float64 }
	Circle  struct{ CX, CY, R float64 }
	AABB    struct{ MinX, MinY, MaxX, MaxY float64 }
	Rect    struct{ CX, CY, UX, UY, HX, HY float64 }
	Ellipse struct{ CX, CY, UX, UY, A, B float64 }
)

// Shape is one of the six.
type Shape interface {
	Point | Segment | Circle | AABB | Rect | Ellipse
	kind() C.int32_t
}

func (Point) kind() C.int32_t   { return C.VESICA_POINT }
func (Segment) kind() C.int32_t { return C.VESICA_SEGMENT }
func (Circle) kind() C.int32_t  { return C.VESICA_CIRCLE }
func (AABB) kind() C.int32_t    { return C.VESICA_AABB }
func (Rect) kind() C.int32_t    { return C.VESICA_RECT }
func (Ellipse) kind() C.int32_t { return C.VESICA_ELLIPSE }

// Error is an error code of the library.
type Error int32

// ErrShape: NaN, infinity, a negative size, no axis, or min above max.
const ErrShape = Error(C.VESICA_E_SHAPE)

func (e Error) Error() string { return C.GoString(C.vesica_strerror(C.int32_t(e))) }

func init() {
	if version := C.vesica_version(); version < C.VESICA_VERSION {
		panic(fmt.Sprintf("vesica %d is older than %d", version, C.VESICA_VERSION))
	}
}

// Overlap tells whether two shapes share a point.
func Overlap[A, B Shape](a A, b B) (bool, error) {
	pa, pb := (*C.double)(unsafe.Pointer(&a)), (*C.double)(unsafe.Pointer(&b))
	return truth(C.vesica_overlap_f64(a.kind(), pa, b.kind(), pb))
}

// OverlapNumbers is Overlap for flat numbers, whose kinds are known at run time only.
func OverlapNumbers[T float32 | float64](kindA int32, a *[6]T, kindB int32, b *[6]T) (bool, error) {
	pa, pb := unsafe.Pointer(a), unsafe.Pointer(b)
	if unsafe.Sizeof(a[0]) == 4 {
		return truth(C.vesica_overlap_f32(C.int32_t(kindA), (*C.float)(pa), C.int32_t(kindB), (*C.float)(pb)))
	}
	return truth(C.vesica_overlap_f64(C.int32_t(kindA), (*C.double)(pa), C.int32_t(kindB), (*C.double)(pb)))
}

func truth(answer C.int32_t) (bool, error) {
	if answer < 0 {
		return false, Error(answer)
	}
	return answer == 1, nil
}

// ClosestPoints is a distance, and two points that are that far apart: (AX, AY) of a and (BX, BY) of b.
type ClosestPoints struct{ Distance, AX, AY, BX, BY float64 }

// Nearest tells how far two shapes are apart, and which of their points are closest.
func Nearest[A, B Shape](a A, b B) (points ClosestPoints, err error) {
	pa, pb := (*C.double)(unsafe.Pointer(&a)), (*C.double)(unsafe.Pointer(&b))
	out := (*C.vesica_closest_points_f64)(unsafe.Pointer(&points))
	if answer := C.vesica_nearest_f64(a.kind(), pa, b.kind(), pb, out); answer < 0 {
		err = Error(answer)
	}
	return points, err
}

// OverlapMany sets out[i] for two slices in step, or for one shape against a slice, and returns how many overlap.
// Where a shape is invalid, out has false for it and every other answer, and the error is returned.
func OverlapMany[A, B Shape](a []A, b []B, out []bool) (int, error) {
	if len(a) == 0 || len(b) == 0 {
		return 0, nil
	}
	if len(out) < len(a) || len(out) < len(b) {
		return 0, Error(C.VESICA_E_ARGUMENT)
	}
	hits := C.overlap_many(a[0].kind(), C.int64_t(len(a)), unsafe.Pointer(&a[0]), C.ptrdiff_t(unsafe.Sizeof(a[0])),
		b[0].kind(), C.int64_t(len(b)), unsafe.Pointer(&b[0]), C.ptrdiff_t(unsafe.Sizeof(b[0])),
		(*C.uint8_t)(unsafe.Pointer(&out[0])))
	if hits < 0 {
		return 0, Error(hits)
	}
	return int(hits), nil
}
