#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# demo_test.sh MOVED WORK: the demo's answers, complaints, exit statuses and pictures on scenes good and bad.
. "$(dirname "${BASH_SOURCE[0]}")/prefix.sh"

demo=$here/../../examples/demo
warnings=(-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Werror)
"$CC" -std=c99 -O1 "${warnings[@]}" -o "$work/demo" "$demo"/*.c "${flags[@]}" -lm
cd "$work"
failures=0

complain() {
  echo "$1"
  failures=$((failures + 1))
}

# check WHAT EXPECTED ACTUAL
check() {
  [ "$2" = "$3" ] || complain "$name: $1 is
$3
and should be
$2"
}

# answered NAME STATUS COMPLAINTS SUMMARY: of the file `scene`. The summary is what its last lines say: answered, right,
# wrong and not known of all queries, then lines with errors.
mkdir pictures
scenes=0
answered() {
  local status=0 line all='' errors=''
  name=$1
  picture="pictures/$((++scenes)) $name.svg"
  ./demo --table -o "$picture" scene >answers 2>complaints || status=$?
  check status "$2" $status
  check complaints "$3" "$(<complaints)"
  while read -ra line; do
    case ${line[*]} in
      'all '*) all=${line[*]:1:4} ;;
      'lines with errors: '*) errors=${line[3]} ;;
    esac
  done <answers
  check summary "$4" "$all, $errors"
  [ -e "$picture" ] || complain "$name: no picture"
}

# scene NAME STATUS COMPLAINTS SUMMARY, the scene itself on standard input. The file is always called `scene`.
scene() {
  cat >scene
  answered "$@"
}

# broken NAME REASON: one line, on standard input, that is refused for that reason, between two good ones.
broken() {
  local good='point 0 0 point 0 0 = 1'
  { echo "$good" && cat && echo "$good"; } >scene
  answered "$1" 1 "scene:2: $2" '2 2 0 0, 1'
}

scene 'a radius' 0 '' '3 3 0 0, 0' <<'EOF'
capsule 0 0 2 0 0.5  round_rect 5 0 1 0 1 1 1.5 = 1
overlap round_rect 0 0 1 0 2 1 0.5  point 2.5 0 = 1
relation capsule 0 0 2 0 1  circle 1 0 0.5 = 5
EOF
broken 'a number too few' 'shape B, number 7 of 7 is missing' <<<'point 0 0 round_rect 0 0 1 0 2 1'

row_start='id,source,rect,0,0,1,0,2,1,circle,5,0,3,,,'

# ---- Good scenes ----------------------------------------------------------------------------------------------------
scene 'both forms, comments, blank lines' 0 '' \
  '4 3 0 1, 0' <<EOF1
# a comment
id,source,kind_a,a0,a1,a2,a3,a4,a5,kind_b,b0,b1,b2,b3,b4,b5,query,expected,tolerance,note

${row_start},overlap,1,0,touching
${row_start},distance,0,1e-15,touching
   rect 0 0 1 0 2 1  ellipse 3,0,1,0, 0x1p-1 0.5 = 0  # a comment
ellipse 0 0 .6 .8 2 1 segment -1 0 1 0
EOF1
check answers '  line  shapes            query                              answer                   known  id
     4  rect-circle       overlap                                 1                       1  id
     5  rect-circle       distance                                0                       0  id
     6  rect-ellipse      overlap                                 0                       0  line 6
     7  ellipse-segment   overlap                                 1                       ?  line 7

query              answered     right     wrong  not known
overlap                   3         2         0          1
distance                  1         1         0          0
all                       4         3         0          1
lines with errors: 0' "$(cat answers)"
check panels 3 "$(grep -c '<g>' "$picture")"
check 'without the table' "$(tail -n 5 answers)" "$(./demo -o picture.svg scene)"

scene 'every query, alone and behind others' 0 '' '9 9 0 0, 0' <<EOF1
overlap point 0 0 point 3 4 = 0
contains circle 0 0 2 circle 1 0 1 = 1
relation, circle 0 0 2, circle 1 0 1 = 6
crossings aabb 0 0 2 2 aabb 1 1 3 3 = 2
distance point 0 0 point 3 4 = 5
boundary_distance circle 0 0 3 point 1 0 = 2
depth aabb 0 0 2 2 aabb 1 0 3 2 = 1
area aabb 0 0 2 2 aabb 1 1 3 3 = 1
iou aabb 0 0 2 2 aabb 0 0 2 1 = 0.5
EOF1

scene 'the corpus' 0 '' '323 323 0 0, 0' <"$here/../corpus/cases.csv"
check 'queries of the corpus' 'overlap 143
distance 45
area 83
iou 52' "$(awk '/^query/ { inside = 1; next } $1 == "all" { exit } inside { print $1, $2 }' answers)"
sources=$(tail -n +2 "$here/../corpus/cases.csv" | cut -d, -f2 | sort -u | wc -l)
check 'what about.txt counts' "323 $sources" "$(grep -Eo '[0-9]+ (questions|public)' "$here/../corpus/about.txt" | cut -d' ' -f1 | xargs)"

scene 'the example' 0 '' \
  '9 8 0 1, 0' \
  <"$demo/example.scene"

printf '\xef\xbb\xbfpoint 0 0 point 0 0=1\r\npoint 0 0 point 1 0=0' >text
scene 'byte order mark, CR LF, no final line end' 0 '' \
  '2 2 0 0, 0' <text

scene 'degenerate, tiny, huge' 0 '' \
  '8 8 0 0, 0' <<EOF1
point 1 1 point 1 1 = 1
segment 0 0 0 0 ellipse 0 0 1 0 0 0 = 1
rect 0 0 1 0 0 3 circle 5e-324 0 0 = 0
circle 0 0 5e-324 circle 1e-323 0 5e-324 = 1
aabb -1.7e308 -1.7e308 1.7e308 1.7e308 point 0 0 = 1
circle 1.7e308 0 1e308 point 0 0 = 0
ellipse 0 0 1e-200 1e-200 1e200 1e-10 point 0.5 0.5 = 1
rect 1e18 0 1 0 1e-7 1e-7 ellipse -1e18 0 1 0 1 1 = 0
EOF1
check 'panels without a drawing' 1 "$(grep -c 'too large to draw' "$picture")"

# ---- Wrong answers --------------------------------------------------------------------------------------------------
scene 'a known answer that is not met' 1 '' \
  '2 1 1 0, 0' <<EOF1
point 0 0 point 0 0 = 0
point 1 1 point 1 1 = 1
EOF1
check 'lines marked' '     1  point-point       overlap                                 1                       0  line 1  WRONG' \
  "$(grep WRONG answers)"
check 'lines marked without the table' "$(grep WRONG answers)" "$(./demo scene | head -n 1)"
check 'panels marked' 1 "$(grep -c '(WRONG)' "$picture")"

scene 'tolerance' 1 '' '4 2 2 0, 0' <<EOF1
i,s,point,0,0,,,,,point,3,4,,,,,distance,5.5,0.5,
i,s,point,0,0,,,,,point,3,4,,,,,distance,4.5,0.5,
i,s,point,0,0,,,,,point,3,4,,,,,distance,5.5,0.4375,
i,s,point,0,0,,,,,point,3,4,,,,,distance,4.5,,
EOF1
check 'panels of one pair' 1 "$(grep -c '<g>' "$picture")"

# ---- Insets ---------------------------------------------------------------------------------------------------------
# insets COUNT SIZES: how many pairs of the last scene are magnified, and the sizes written there.
insets() {
  check insets "$1" "$(grep -c '<svg x=' "$picture")"
  check sizes "$2" "$(grep -o 'class="s"[^<]*' "$picture" | sed 's/.*>//' | xargs)"
}
scene 'too close to see' 0 '' '9 9 0 0, 0' <<EOF1
circle 0 0 1 circle 0x1.0000000000001p+1 0 1 = 0
circle 0 0 1 circle 2 0 1 = 1
circle 0 0 1 circle 0x1.fffffffffffffp+0 0 1 = 1
aabb 0 0 1 1 rect 1.701 0.5 0.6 0.8 0.5 0.5 = 0
segment 0 0 1 0 segment 1 1e-9 2 1e-9 = 0
segment -1 0 0 0 segment 1e-30 0 1 0 = 0
point 1 0 ellipse 0 0 1 0 1 0.5 = 1
circle 0 0 1 circle 2.1 0 1 = 0
circle 0 0 1 circle 1 0 1 = 1
EOF1
insets 7 '4.44e-16 0.001 1e-09 1e-30 2.22e-16 0 0'

# ends: the right end of the first shape and the left end of the second, in pixels from the middle, in each inset.
ends() {
  awk -F'"' '/^<svg x=/ { inside = 1; shapes = 0 }
             /^<.svg>/ { inside = 0 }
             inside && /^<path class="[oa][ab]"/ {
               n = split($4, corners, /[ MLZ]+/)
               end = corners[2]
               for (i = 4; i < n; i += 2) if (shapes ? corners[i] < end + 0 : corners[i] > end + 0) end = corners[i]
               line = shapes++ ? line " " end : end
               if (shapes == 2) print line
             }' "$1"
}
check 'ends of a corner at a side' '-8.00 8.00' "$(ends "$picture" | sed -n 2p)"
# A gap of one digit of a double takes a long double that is longer.
if "$CC" -dM -E -x c /dev/null | grep -Eq '__LDBL_MANT_DIG__ (64|113)'; then
  check 'ends of the smallest gap' '-8.00 8.00' "$(ends "$picture" | sed -n 1p)"
  check 'ends of the smallest overlap' '8.00 -8.00' "$(ends "$picture" | sed -n 5p)"
fi
scene 'nothing too close' 0 '' '1 0 0 1, 0' <<<'point 0 0 point 1 0'
insets 0 ''
check 'sections' 'Plain to see' "$(grep -o 'Apart, by\|Overlapping\|Touching\|Plain to see' "$picture" | xargs)"

# ---- Lines that are refused -----------------------------------------------------------------------------------------
broken 'no kind' "'square' is neither a query nor a kind" <<<'square 0 0 1'
broken 'no kind, commas' "'sqare' is neither a query nor a kind, and a row has 20 fields, not 4" <<<'sqare,0,0,1'
broken 'second kind' "shape B: unknown kind 'disk'" <<<'point 0 0 disk 0 0 1'
broken 'a query alone' 'shape A is missing' <<<'distance'
broken 'two queries' "shape A: unknown kind 'area'" <<<'distance area point 0 0 point 0 0'
broken 'a known answer that is no number' "known answer: 'far' is not a number" <<<'distance point 0 0 point 0 0 = far'
broken 'a known answer that is NaN' "known answer 'nan' is not finite" <<<'distance point 0 0 point 0 0 = nan'
broken 'a question without an answer' 'iou: an argument is out of range' \
  <<<'iou point 0 0 point 0 0'
broken 'an answer out of range' 'distance: the result is out of the range of its type' \
  <<<'distance point -1.7e308 0 point 1.7e308 0'
broken 'one shape' 'shape B is missing' <<<'circle 0 0 1'
broken 'too few numbers' 'shape B, number 3 of 3 is missing' <<<'point 0 0 circle 0 0 = 1'
broken 'a kind for a number' "shape A, number 3 of 4: 'point' is not a number" <<<'segment 0 0 point 0 0'
broken 'half a number' "shape A, number 2 of 2: '1.5x' is not a number" <<<'point 0 1.5x point 0 0'
broken 'too many numbers' "'7' after the two shapes" <<<'point 0 0 point 0 0 7'
broken 'known answer' "known answer 'yes' is not 0 or 1" <<<'point 0 0 point 0 0 = yes'
broken 'known answer missing' "known answer '' is not 0 or 1" <<<'point 0 0 point 0 0 ='
broken 'after the known answer' "known answer '1 1' is not 0 or 1" <<<'point 0 0 point 0 0 = 1 1'
broken 'unprintable' "'?[31m??' is neither a query nor a kind" < <(printf '\e[31m\xc3\xa9\n')

broken 'negative size' 'shape A (circle) is invalid: a size is negative' \
  <<<'circle 0 0 -1 point 0 0'
broken 'no axis' 'shape B (rect) is invalid: the axis is (0, 0)' <<<'point 0 0 rect 0 0 0 0 1 1'
broken 'inverted' "shape A (aabb) is invalid: min exceeds max" <<<'aabb 1 0 0 1 point 0 0'
broken 'not a number' 'shape A (point) is invalid: a number is NaN or infinite' <<<'point nan 0 point 0 0'
broken 'too large' 'shape A (point) is invalid: a number is NaN or infinite' <<<'point 1e999 0 point 0 0'

broken 'fields' "'id' is neither a query nor a kind, and a row has 20 fields, not 19" <<<"${row_start},overlap,1,0"
broken 'row kind' "kind_a: unknown kind 'box'" <<<'i,s,box,0,0,1,,,,point,0,0,,,,,overlap,1,0,'
broken 'row number' "a1: 'z' is not a number" <<<'i,s,point,0,z,,,,,point,0,0,,,,,overlap,1,0,'
broken 'row number missing' 'b1 is missing' <<<'i,s,point,0,0,,,,,point,0,,,,,,overlap,1,0,'
broken 'row number too many' "b3: '9', but circle has only 3 numbers" <<<'i,s,point,0,0,,,,,circle,0,0,1,9,,,overlap,1,0,'
broken 'row shape' 'shape A (circle) is invalid: a size is negative' \
  <<<'i,s,circle,0,0,-1,,,,circle,0,0,1,,,,distance,1,0,'
broken 'row query' "unknown query 'touches'" <<<"${row_start},touches,1,0,"
broken 'row known' "known answer '2' is not 0 or 1" <<<"${row_start},overlap,2,0,"
broken 'row known, number' "known answer: 'far' is not a number" <<<"${row_start},distance,far,0,"
broken 'row number NaN' 'shape B (circle) is invalid: a number is NaN or infinite' \
  <<<'i,s,point,0,0,,,,,circle,0,nan,1,,,,overlap,1,0,'
broken 'row tolerance NaN' "tolerance 'nan' is not 0 or more" <<<"${row_start},distance,1,nan,"
broken 'row tolerance' "tolerance '-1' is not 0 or more" <<<"${row_start},distance,1,-1,"

broken 'NUL byte' 'a NUL byte: this is not a text file' < <(printf 'point 0 0 point 0 0\0 = 1\n')
broken 'long line' 'line longer than 4095 bytes' < <(printf 'point 0 0 point 0 0 %05000d\n' 1)
scene 'longest line' 0 '' \
  '1 0 0 1, 0' \
  < <(printf 'point 0 0 %4075s point 0 0\r\n' ' ')

# ---- Files ----------------------------------------------------------------------------------------------------------
none='0 0 0 0, 1'
scene 'empty file' 1 'scene:1: no pair in this file' "$none" </dev/null
scene 'comments only' 1 'scene:2: no pair in this file' "$none" <<<'# nothing'

# unusable NAME COMPLAINT ARGUMENT...
unusable() {
  local status=0 complaint=$2
  name=$1
  shift 2
  ./demo "$@" >answers 2>complaints || status=$?
  check status 2 $status
  check complaint "$complaint" "$(cat complaints)"
}
echo 'point 0 0 point 0 0' >scene
unusable 'missing file' 'nowhere: cannot read: No such file or directory' -o picture.svg nowhere
unusable 'directory' '.: cannot read: Is a directory' -o picture.svg .
unusable 'read error' '/proc/self/mem: cannot read: Input/output error' -o picture.svg /proc/self/mem
unusable 'picture' 'nowhere/picture.svg: cannot write: No such file or directory' -o nowhere/picture.svg scene
unusable 'no argument' 'usage: demo [--table] [-o PICTURE] SCENE'
unusable 'two scenes' 'usage: demo [--table] [-o PICTURE] SCENE' scene scene
unusable 'unknown option' 'usage: demo [--table] [-o PICTURE] SCENE' -x scene

# ---- Markup in an id, and more pairs than a picture holds -------------------------------------------------------------
scene 'markup' 0 '' \
  '1 1 0 0, 0' \
  <<<'<b>&amp;]]>",s,point,0,0,,,,,point,0,0,,,,,overlap,1,0,'
check 'ids in the picture' 2 "$(grep -c '&lt;b&gt;&amp;amp;]]&gt;"' "$picture")"
scene 'many pairs' 0 '' \
  '500 500 0 0, 0' \
  < <(for ((i = 0; i < 500; i++)); do echo "circle 0 0 1 circle $i 0 1 = $((i <= 2))"; done)
check panels 400 "$(grep -c '<g>' "$picture")"
check heading '500 questions about 500 pairs of shapes, the first 400 drawn' \
  "$(grep -o '[0-9]* questions[^<]*' "$picture")"

# ---- Pictures of all scenes -----------------------------------------------------------------------------------------
name=pictures
xmllint --noout pictures/*.svg || complain 'a picture is not XML'
awk '{ sub(/<title>[^<]*/, "") }
     tolower($0) ~ /[^a-z](nan|inf)[^a-z]/ { print FILENAME ": a picture of no numbers"; found = 1 }
     END { exit found }' pictures/*.svg || failures=$((failures + 1))

[ $failures = 0 ] || exit 1
echo "all scenes as expected"
