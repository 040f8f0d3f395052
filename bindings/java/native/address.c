/* SPDX-License-Identifier: Apache-2.0 */
#include <stdint.h>

#include "lend.h"

/* The address of a direct buffer. Arrays move, so they have no lasting address. */
JNIEXPORT jlong JNICALL Java_vesica_Shapes_address(JNIEnv* env, jclass type, jobject buffer) {
  (void)type;
  return (jlong)(intptr_t)(*env)->GetDirectBufferAddress(env, buffer);
}
