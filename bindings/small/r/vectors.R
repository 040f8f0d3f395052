# SPDX-License-Identifier: Apache-2.0
# vectors.R FILE: the shared vectors (bindings/vectors) by vesica.R. Exit status 0 when all answers are right.
source("vesica.R")

all_right <- TRUE
check <- function(line, answer, expected) {
  if (answer == expected) return()
  cat("line ", line, ": ", answer, ", not ", expected, "\n", sep = "")
  all_right <<- FALSE
}

numbers <- function(words) {
  bytes <- strtoi(substring(paste(words, collapse = ""), seq(1, 95, 2), seq(2, 96, 2)), 16L)
  readBin(as.raw(bytes), "double", 6, endian = "big")
}

text <- readLines(commandArgs(TRUE)[1])
lines <- grep("^#", text, invert = TRUE)
words <- do.call(rbind, strsplit(text[lines], " "))
many <- words[, 1] == "many"

# R has no float: the same numbers in double have the same answers.
for (i in which(!many)) {
  w <- words[i, ]
  answer <- tryCatch(
    as.integer(overlap(w[3], numbers(w[4:9]), w[10], numbers(w[11:16]))),
    vesica_error = function(e) e$code
  )
  check(lines[i], answer, as.integer(w[2]))
}

batch <- words[many, ]
expected <- as.integer(batch[, 2])
rects <- t(apply(batch[, 4:9], 1, numbers))
ellipses <- as.data.frame(t(apply(batch[, 11:16], 1, numbers)))
valid <- seq_len(which(expected < 0)[1] - 1)
count <- sum(overlap_many(vesica_kinds["rect"], rects[valid, ], vesica_kinds["ellipse"], ellipses[valid, ]))
check("count", count, sum(expected[valid]))
# With an invalid element, an error: and yet every valid one has its answer.
error <- tryCatch(
  overlap_many(vesica_kinds["rect"], rects, vesica_kinds["ellipse"], ellipses),
  vesica_error = identity
)
check("error", error$code, -2)
invisible(Map(check, lines[many], as.integer(error$hits), pmax(expected, 0)))

tryCatch(
  overlap(vesica_kinds["point"], c(NaN, 0), vesica_kinds["circle"], c(0, 0, 1)),
  vesica_error = function(e) cat("NaN: ", conditionMessage(e), "\n", sep = "")
)
closest <- nearest(vesica_kinds["aabb"], c(0, 0, 2, 2), vesica_kinds["circle"], c(6, 1, 1))
if (all(closest == c(3, 2, 1, 5, 1))) cat("nearest: as in C\n")
cat(sum(!many), " calls, ", sum(many), " in a batch\n", sep = "")
quit(status = if (all_right) 0 else 1)
