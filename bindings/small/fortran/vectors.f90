! SPDX-License-Identifier: Apache-2.0
!> vectors FILE: the shared vectors (bindings/vectors) by module vesica. Exit status 0 when all answers are right.
program vectors
  use, intrinsic :: iso_c_binding
  use, intrinsic :: ieee_arithmetic
  use vesica
  implicit none
  integer, parameter :: batch_limit = 64
  character(500) :: text
  character(4) :: what
  character(16) :: words(12)
  integer :: unit, status, line = 0, calls = 0, batch = 0, expected, kinds(2), i, valid
  integer(c_int64_t) :: bits(12)
  real(c_double) :: numbers(12)
  ! Shapes as a part of larger records.
  real(c_double) :: rects(8, batch_limit), ellipses(8, batch_limit)
  integer :: lines(batch_limit), codes(batch_limit)
  logical(c_bool) :: out(batch_limit)
  logical :: all_right = .true.
  type(vesica_closest_points_f64) :: closest

  call vesica_require_version()
  call get_command_argument(1, text)
  open (newunit=unit, file=text, action='read', status='old')
  do
    read (unit, '(a)', iostat=status) text
    if (status /= 0) exit
    line = line + 1
    if (text(1:1) == '#') cycle
    read (text, *) what, expected, kinds(1), words(1:6), kinds(2), words(7:12)
    read (words, '(z16)') bits
    numbers = transfer(bits, numbers)
    select case (what)
    case ('f64')
      call check(line, overlap(kinds(1), numbers(1:6), kinds(2), numbers(7:12)), expected)
      calls = calls + 1
    case ('f32')
      call check(line, overlap(kinds(1), real(numbers(1:6), c_float), kinds(2), real(numbers(7:12), c_float)), expected)
      calls = calls + 1
    case ('many')
      batch = batch + 1
      lines(batch) = line
      codes(batch) = expected
      rects(2:7, batch) = numbers(1:6)
      ellipses(2:7, batch) = numbers(7:12)
    end select
  end do

  valid = findloc(codes(:batch) < 0, .true., dim=1) - 1
  if (many(valid) /= sum(codes(:valid))) all_right = .false.
  ! With an invalid element, an error: and yet every valid one has its answer.
  if (many(batch) /= vesica_e_shape) all_right = .false.
  do i = 1, batch
    call check(lines(i), merge(1, 0, out(i)), max(codes(i), 0))
  end do

  status = overlap(vesica_point, [ieee_value(0d0, ieee_quiet_nan), 0d0], vesica_circle, [0d0, 0d0, 1d0])
  if (status < 0) print '(2a)', 'NaN: ', vesica_message(status)
  status = closest_points(vesica_aabb, [0d0, 0d0, 2d0, 2d0], vesica_circle, [6d0, 1d0, 1d0], closest)
  numbers(:5) = [closest%distance, closest%ax, closest%ay, closest%bx, closest%by] - [3, 2, 1, 5, 1]
  if (status == 0 .and. maxval(abs(numbers(:5))) <= 0) then
    print '(a)', 'nearest: as in C'
  end if
  print '(i0, a, i0, a)', calls, ' calls, ', batch, ' in a batch'
  if (.not. all_right) stop 1, quiet=.true.

contains

  subroutine check(line, answer, expected)
    integer, intent(in) :: line, answer, expected
    if (answer == expected) return
    print '(a, i0, a, i0, a, i0)', 'line ', line, ': ', answer, ', not ', expected
    all_right = .false.
  end subroutine

  integer(c_int64_t) function many(count)
    integer, intent(in) :: count
    many = overlap_many(vesica_rect, rects(2:7, :count), vesica_ellipse, ellipses(2:7, :count), out)
  end function

end program
