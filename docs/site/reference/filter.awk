# What doxygen reads of a header: the comment at its top as that of the file, headings ("---- Name ----") as groups of
# members with their text, and the parts of a comment ("Returns: ...") as paragraphs of their own.
FNR == 1 && $0 == "/*" { print "/** @file"; next }
FNR == 2 && /^\/\/\/ / { print "/// @file" }

function close_group() {
  if (grouped) print "/**@}*/"
  grouped = 0
}

/^#ifdef __cplusplus$/ { close_group() }

/^\/\* ---- .* ----( \*\/)?$/ {
  close_group()
  heading = $0
  sub(/^\/\* ---- /, "", heading)
  whole = sub(/ ---- \*\/$/, "", heading)
  sub(/ ----$/, "", heading)
  sub(/\.$/, "", heading)
  print "/** @name " heading
  if (whole) print " */\n/**@{*/"
  grouped = 1
  inside = !whole
  next
}

{
  match($0, /^( \* |\/\/\/ )/)
  lead = RLENGTH > 0 ? substr($0, 1, RLENGTH) : ""
  rest = RLENGTH > 0 ? substr($0, RLENGTH + 1) : ""
  if (match(rest, /^(Requires|Returns|Errors|Accuracy|Cost|Since|Bound|Laws|Idea|Source|Differs|Wrong in print): */)) {
    colon = index(rest, ":")
    print lead "\\par " substr(rest, 1, colon - 1)
    print lead substr(rest, RLENGTH + 1)
  } else {
    print
  }
}

inside && $0 == " */" {
  print "/**@{*/"
  inside = 0
}
