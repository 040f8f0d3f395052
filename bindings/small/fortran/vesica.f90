! SPDX-License-Identifier: Apache-2.0
!> Exact overlap queries between plain 2D shapes. Touching counts. Fortran has no exceptions: a negative result is an
!> error, and vesica_message says what it means.
!> vesica_c has every function and constant.
module vesica
  use, intrinsic :: iso_c_binding
  use vesica_c
  implicit none
  private
  public :: overlap, overlap_many, closest_points, vesica_message, vesica_require_version, vesica_closest_points_f64
  public :: vesica_point, vesica_segment, vesica_circle, vesica_aabb, vesica_rect, vesica_ellipse, &
    vesica_capsule, vesica_round_rect
  public :: vesica_e_shape, vesica_e_kind, vesica_e_argument

  !> How many numbers a shape of each kind has.
  integer, parameter, public :: vesica_numbers(0:7) = [2, 4, 3, 4, 6, 6, 5, 7]

  !> overlap(kind_a, a, kind_b, b): 1 where two shapes, arrays of their numbers, share a point, else 0; or an error.
  interface overlap
    module procedure overlap_double, overlap_float
  end interface

contains

  !> Once, before the first call: stops the program where the library that was loaded will not do.
  subroutine vesica_require_version()
    character(80) :: message
    if (vesica_version() >= vesica_declared_version) return
    write (message, '(a, i0, a, i0)') 'vesica ', vesica_version(), ' is older than ', vesica_declared_version
    error stop message
  end subroutine

  function vesica_message(code) result(message)
    integer, intent(in) :: code
    character(:), allocatable :: message
    character(kind=c_char), pointer :: text(:)
    integer :: i
    call c_f_pointer(vesica_strerror(int(code, c_int32_t)), text, [1000])
    message = ''
    do i = 1, size(text)
      if (text(i) == c_null_char) exit
      message = message // text(i)
    end do
  end function

  integer function overlap_double(kind_a, a, kind_b, b)
    integer(c_int32_t), intent(in) :: kind_a, kind_b
    real(c_double), intent(in) :: a(:), b(:)
    overlap_double = argument_error(kind_a, size(a), kind_b, size(b))
    if (overlap_double == 0) overlap_double = vesica_overlap_f64(kind_a, a, kind_b, b)
  end function

  integer function overlap_float(kind_a, a, kind_b, b)
    integer(c_int32_t), intent(in) :: kind_a, kind_b
    real(c_float), intent(in) :: a(:), b(:)
    overlap_float = argument_error(kind_a, size(a), kind_b, size(b))
    if (overlap_float == 0) overlap_float = vesica_overlap_f32(kind_a, a, kind_b, b)
  end function

  !> How far apart are two shapes, and which of their points are closest? 0, or an error.
  integer function closest_points(kind_a, a, kind_b, b, points)
    integer(c_int32_t), intent(in) :: kind_a, kind_b
    real(c_double), intent(in) :: a(:), b(:)
    type(vesica_closest_points_f64), intent(out) :: points
    closest_points = argument_error(kind_a, size(a), kind_b, size(b))
    if (closest_points == 0) closest_points = vesica_nearest_f64(kind_a, a, kind_b, b, points)
  end function

  !> Two arrays of shapes in step, a(:, i) being shape i; an array of one shape is repeated. Sections of arrays are read
  !> where they are. out(i) says whether they overlap; the result is how many do. Where a shape is invalid, out is false
  !> for it and right for every other, and the result is vesica_e_shape.
  integer(c_int64_t) function overlap_many(kind_a, a, kind_b, b, out)
    integer(c_int32_t), intent(in) :: kind_a, kind_b
    real(c_double), intent(in), target :: a(:, :), b(:, :)
    logical(c_bool), intent(out), contiguous, target :: out(:)
    overlap_many = argument_error(kind_a, size(a, 1), kind_b, size(b, 1))
    if (size(a, 2) > 0 .and. size(b, 2) > 0 .and. size(out) < max(size(a, 2), size(b, 2))) then
      overlap_many = vesica_e_argument
    end if
    if (overlap_many == 0) overlap_many = vesica_overlap_many_f64(view(kind_a, a), view(kind_b, b), c_loc(out))
  end function

  integer function argument_error(kind_a, size_a, kind_b, size_b) result(error)
    integer(c_int32_t), intent(in) :: kind_a, kind_b
    integer, intent(in) :: size_a, size_b
    error = vesica_e_kind
    if (min(kind_a, kind_b) < 0 .or. max(kind_a, kind_b) > 7) return
    error = vesica_e_argument
    if (size_a < vesica_numbers(kind_a) .or. size_b < vesica_numbers(kind_b)) return
    error = 0
  end function

  type(vesica_shapes_f64) function view(kind, shapes)
    integer(c_int32_t), intent(in) :: kind
    real(c_double), intent(in), target :: shapes(:, :)
    integer :: i
    view = vesica_shapes_f64(kind, 0, size(shapes, 2), 0, c_null_ptr, c_null_ptr, c_null_ptr, 0)
    if (view%count == 0) return
    do i = 1, vesica_numbers(kind)
      view%field(i) = c_loc(shapes(i, 1))
    end do
    if (view%count > 1) view%stride = transfer(c_loc(shapes(1, 2)), view%stride) - transfer(view%field(1), view%stride)
  end function

end module
