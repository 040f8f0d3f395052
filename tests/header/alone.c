/* SPDX-License-Identifier: Apache-2.0 */
/* vesica.h before anything else, compiled as every C and C++ it promises to be. */
#include <vesica.h>

/* Structs of one scalar type and no padding, so that they can be read as flat numbers. */
typedef char point_f64_is_flat[sizeof(vesica_point_f64) == 2 * sizeof(double) ? 1 : -1];
typedef char segment_f64_is_flat[sizeof(vesica_segment_f64) == 4 * sizeof(double) ? 1 : -1];
typedef char circle_f64_is_flat[sizeof(vesica_circle_f64) == 3 * sizeof(double) ? 1 : -1];
typedef char aabb_f64_is_flat[sizeof(vesica_aabb_f64) == 4 * sizeof(double) ? 1 : -1];
typedef char rect_f64_is_flat[sizeof(vesica_rect_f64) == 6 * sizeof(double) ? 1 : -1];
typedef char ellipse_f64_is_flat[sizeof(vesica_ellipse_f64) == 6 * sizeof(double) ? 1 : -1];
typedef char point_f32_is_flat[sizeof(vesica_point_f32) == 2 * sizeof(float) ? 1 : -1];
typedef char segment_f32_is_flat[sizeof(vesica_segment_f32) == 4 * sizeof(float) ? 1 : -1];
typedef char circle_f32_is_flat[sizeof(vesica_circle_f32) == 3 * sizeof(float) ? 1 : -1];
typedef char aabb_f32_is_flat[sizeof(vesica_aabb_f32) == 4 * sizeof(float) ? 1 : -1];
typedef char rect_f32_is_flat[sizeof(vesica_rect_f32) == 6 * sizeof(float) ? 1 : -1];
typedef char ellipse_f32_is_flat[sizeof(vesica_ellipse_f32) == 6 * sizeof(float) ? 1 : -1];

#if !defined(VESICA_DETECTION_H) || !defined(VESICA_INDEX_H) || !defined(VESICA_MOTION_H) || !defined(VESICA_TOPOLOGY_H)
#error "vesica.h does not bring vesica_detection.h, vesica_index.h, vesica_motion.h and vesica_topology.h"
#endif

#if VESICA_VERSION != VESICA_VERSION_MAJOR * 10000 + VESICA_VERSION_MINOR * 100 + VESICA_VERSION_PATCH
#error "VESICA_VERSION does not fit its parts"
#endif

/* The macros of C11 are for C11 alone. */
#if !defined(__cplusplus) && __STDC_VERSION__ >= 201112L
#ifndef vesica_overlap
#error "no C11 macros"
#endif
#elif defined(vesica_overlap) || defined(VESICA_GENERIC_H)
#error "C11 macros in another language"
#endif

int main(void) {
  const vesica_circle_f64 disc = {0, 0, 1};
  const vesica_ellipse_f64 ellipse = {0, 0, 1, 0, 2, 1};
#ifdef vesica_overlap
  if (vesica_overlap(&disc, &ellipse) != 1) return 1;
#endif
  return vesica_overlap_circle_ellipse_f64(&disc, &ellipse) != 1;
}
