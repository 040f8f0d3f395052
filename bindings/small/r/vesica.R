# SPDX-License-Identifier: Apache-2.0
# Exact overlap queries between plain 2D shapes, by vesica_r.so. Touching counts.
#
# An error of the library is a condition of class vesica_error with its code; where a shape of an array is invalid, the
# condition's hits has FALSE for it and every other answer.

vesica_needed <- 100L # the version that this file was written to
vesica_kinds <- c(point = 0L, segment = 1L, circle = 2L, aabb = 3L, rect = 4L, ellipse = 5L)

dyn.load("vesica_r.so")
local({
  version <- .Call("vesica_r_version")
  if (version < vesica_needed) stop("vesica ", version, " is older than ", vesica_needed)
})

vesica_error <- function(code, hits = NULL) {
  message <- .Call("vesica_r_strerror", as.integer(code))
  fields <- list(message = message, call = NULL, code = code, hits = hits)
  structure(fields, class = c("vesica_error", "error", "condition"))
}

# Do two shapes, vectors of their numbers, share a point?
overlap <- function(kind_a, a, kind_b, b) {
  answer <- .Call("vesica_r_overlap", as.integer(kind_a), as.double(a), as.integer(kind_b), as.double(b))
  if (answer < 0) stop(vesica_error(answer))
  answer == 1L
}

# How far apart are two shapes, and which of their points are closest? c(distance, ax, ay, bx, by).
nearest <- function(kind_a, a, kind_b, b) {
  answer <- .Call("vesica_r_nearest", as.integer(kind_a), as.double(a), as.integer(kind_b), as.double(b))
  if (is.integer(answer)) stop(vesica_error(answer))
  setNames(answer, c("distance", "ax", "ay", "bx", "by"))
}

# Whether two arrays of shapes in step overlap, or one shape and each of an array. An array is a data frame of double
# columns, or a double matrix with a shape a row; neither is copied.
overlap_many <- function(kind_a, a, kind_b, b) {
  answer <- .Call("vesica_r_overlap_many", as.integer(kind_a), a, as.integer(kind_b), b)
  if (answer[[1]] < 0) stop(vesica_error(answer[[1]], answer[[2]]))
  answer[[2]]
}
