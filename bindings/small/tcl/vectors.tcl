# SPDX-License-Identifier: Apache-2.0
# vectors.tcl LIBRARY FILE: the shared vectors (bindings/vectors) by vesica_tcl.c. Exit status 0 when all are right.
lassign $argv library path
load $library Vesica

set all_right 1
proc check {line answer expected} {
    if {$answer == $expected} return
    puts "line $line: $answer, not $expected"
    set ::all_right 0
}

# What the command returns, or the code of its error.
proc answer {args} {
    try {
        return [uplevel 1 $args]
    } trap VESICA {message options} {
        return [lindex [dict get $options -errorcode] 1]
    }
}

proc numbers {words} {
    binary scan [binary format [string repeat H16 [llength $words]] {*}$words] Q* numbers
    return $numbers
}

set calls 0
set line 0
set lines {}
set file [open $path]
while {[gets $file text] >= 0} {
    incr line
    if {[string index $text 0] eq "#"} continue
    set words [split $text]
    lassign $words what code kind_a
    set kind_b [lindex $words 9]
    set a [numbers [lrange $words 3 8]]
    set b [numbers [lrange $words 10 15]]
    switch $what {
        f64 { check $line [answer vesica::overlap $kind_a $a $kind_b $b] $code }
        f32 { check $line [answer vesica::overlap_float $kind_a $a $kind_b $b] $code }
        many {
            lappend lines $line
            lappend expected $code
            append rects [binary format d6 $a]
            append ellipses [binary format d6 $b]
        }
    }
    incr calls [expr {$what ne "many"}]
}

set valid [lsearch $expected -2]
set last [expr {48 * $valid - 1}]
set hits [tcl::mathop::+ {*}[lrange $expected 0 $valid-1]]
check count [vesica::overlap_many 4 [string range $rects 0 $last] 5 [string range $ellipses 0 $last] out] $hits
# With an invalid element, an error: and yet every valid one has its answer.
check error [answer vesica::overlap_many 4 $rects 5 $ellipses out] -2
binary scan $out c* hits
foreach line $lines hit $hits code $expected {
    check $line $hit [expr {max($code, 0)}]
}

catch {vesica::overlap 0 {NaN 0} 2 {0 0 1}} message
puts "NaN: $message"
if {[vesica::nearest 3 {0 0 2 2} 2 {6 1 1}] eq {3.0 2.0 1.0 5.0 1.0}} {
    puts "nearest: as in C"
}
puts "$calls calls, [llength $lines] in a batch"
exit [expr {!$all_right}]
