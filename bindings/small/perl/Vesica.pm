# SPDX-License-Identifier: Apache-2.0
package Vesica;

# Exact overlap queries between plain 2D shapes. Touching counts.
use strict;
use warnings;
use Carp qw(croak);
use FFI::Platypus 1.00;
use FFI::Platypus::Buffer qw(grow scalar_to_pointer set_used_length);

use VesicaDeclarations;
use constant \%VesicaDeclarations::CONSTANTS;

my $ffi = FFI::Platypus->new(api => 1, lib => 'libvesica.so.0');
my $version = $ffi->function(vesica_version => [] => 'sint32')->call;
die "vesica $version is older than ${\VERSION}\n" if $version < VERSION;

$ffi->attach(@$_) for @VesicaDeclarations::FUNCTIONS;

# Do two shapes, references to lists of their numbers, share a point?
sub overlap {
    my ($kind_a, $numbers_a, $kind_b, $numbers_b) = @_;
    _need_numbers($kind_a, $numbers_a);
    _need_numbers($kind_b, $numbers_b);
    return _checked(vesica_overlap_f64($kind_a, $numbers_a, $kind_b, $numbers_b)) == 1;
}

# The same of floats.
sub overlap_float {
    my ($kind_a, $numbers_a, $kind_b, $numbers_b) = @_;
    _need_numbers($kind_a, $numbers_a);
    _need_numbers($kind_b, $numbers_b);
    return _checked(vesica_overlap_f32($kind_a, $numbers_a, $kind_b, $numbers_b)) == 1;
}

# How far apart are two shapes, and which of their points are closest? A reference to a hash of distance, ax, ay (of a),
# bx and by (of b).
sub nearest {
    my ($kind_a, $numbers_a, $kind_b, $numbers_b) = @_;
    _need_numbers($kind_a, $numbers_a);
    _need_numbers($kind_b, $numbers_b);
    my $out = _buffer(40);
    _checked(vesica_nearest_f64($kind_a, $numbers_a, $kind_b, $numbers_b, scalar_to_pointer $out));
    my %closest;
    @closest{qw(distance ax ay bx by)} = unpack 'd5', $out;
    return \%closest;
}

# overlap_many(KIND_A, $a, KIND_B, $b, $out): two arrays of shapes in step, each a string of their numbers as pack('d*')
# makes it, which is not copied; an array of one shape is repeated. $out becomes a string of a byte for each, 1 where
# they overlap, else 0; returns how many do. Where a shape is invalid, $out has 0 for it and every other answer, and the
# error is thrown.
sub overlap_many {
    my ($kind_a, $kind_b) = @_[0, 2];
    my ($count_a, $view_a) = _view($kind_a, $_[1]);
    my ($count_b, $view_b) = _view($kind_b, $_[3]);
    my $longer = $count_a > $count_b ? $count_a : $count_b;
    my $out = _buffer($count_a && $count_b ? $longer : 0);
    my $answer = vesica_overlap_many_f64(map { scalar_to_pointer $_ } $view_a, $view_b, $out);
    $_[4] = $out;
    return _checked($answer);
}

# The count of shapes in a string, and a vesica_shapes_f64 of them, which the library alone fills in and reads.
sub _view {
    my $size = 8 * _checked(vesica_field_count($_[0]));
    my $count = int(length($_[1]) / $size);
    my $view = _buffer(112);
    _checked(vesica_shapes_from_records_f64($_[0], $count, scalar_to_pointer($_[1]), $size, scalar_to_pointer $view));
    return ($count, $view);
}

# A string that shares its bytes with no other, for the library to write to.
sub _buffer {
    my $size = shift;
    grow(my $buffer, $size || 1);
    set_used_length($buffer, $size);
    return $buffer;
}

sub _need_numbers {
    my ($kind, $numbers) = @_;
    croak "too few numbers for a shape of kind $kind" if @$numbers < vesica_field_count($kind);
}

sub _checked {
    my $answer = shift;
    die bless { code => $answer }, 'Vesica::Error' if $answer < 0;
    return $answer;
}

package Vesica::Error;

# What is thrown: an object with a code, as text its meaning.
use overload '""' => sub { Vesica::vesica_strerror($_[0]{code}) }, bool => sub { 1 };

sub code { return $_[0]{code} }

1;
