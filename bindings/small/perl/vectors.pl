# SPDX-License-Identifier: Apache-2.0
# vectors.pl FILE: the shared vectors (bindings/vectors) by Vesica.pm. Exit status 0 when all answers are right.
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin;
use Vesica;

my $all_right = 1;

sub check {
    my ($line, $answer, $expected) = @_;
    return if $answer == $expected;
    print "line $line: $answer, not $expected\n";
    $all_right = 0;
}

# What the call returns, or the code of its error.
sub answer {
    my $call = shift;
    my $result = eval { $call->(@_) || 0 };
    return $result if defined $result;
    die $@ unless ref $@ && $@->isa('Vesica::Error');
    return $@->code;
}

my ($calls, @batch) = (0);
open my $file, '<', $ARGV[0] or die "$ARGV[0]: $!\n";
while (my $text = <$file>) {
    next if $text =~ /^#/;
    my ($what, $expected, @words) = split ' ', $text;
    my ($kind_a, $kind_b) = @words[0, 7];
    my ($numbers_a, $numbers_b) = map { [unpack 'd>*', pack '(H16)*', @$_] } [@words[1 .. 6]], [@words[8 .. 13]];
    if ($what eq 'many') {
        push @batch, { line => $., expected => $expected, a => $numbers_a, b => $numbers_b };
        next;
    }
    my $call = $what eq 'f64' ? \&Vesica::overlap : \&Vesica::overlap_float;
    check($., answer($call, $kind_a, $numbers_a, $kind_b, $numbers_b), $expected);
    ++$calls;
}

my $out;
my $many = sub {
    my $rects    = pack 'd*', map { @{ $_->{a} } } @_;
    my $ellipses = pack 'd*', map { @{ $_->{b} } } @_;
    return Vesica::overlap_many(Vesica::RECT, $rects, Vesica::ELLIPSE, $ellipses, $out);
};
my ($hits, @valid) = (0);
for my $row (@batch) {
    last if $row->{expected} < 0;
    push @valid, $row;
    $hits += $row->{expected};
}
check('count', $many->(@valid), $hits);

# With an invalid element, an error: and yet every valid one has its answer.
check('error', answer($many, @batch), -2);
my @hit = unpack 'C*', $out;
check($batch[$_]{line}, $hit[$_], $batch[$_]{expected} > 0 ? 1 : 0) for 0 .. $#batch;

eval { Vesica::overlap(Vesica::POINT, ['nan', 0], Vesica::CIRCLE, [0, 0, 1]) };
print "NaN: $@\n";
my $closest = Vesica::nearest(Vesica::AABB, [0, 0, 2, 2], Vesica::CIRCLE, [6, 1, 1]);
print "nearest: as in C\n" if "@$closest{qw(distance ax ay bx by)}" eq '3 2 1 5 1';
print "$calls calls, ${\scalar @batch} in a batch\n";
exit !$all_right;
