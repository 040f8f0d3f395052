/* SPDX-License-Identifier: Apache-2.0 */
#include <stdint.h>

#include "lend.h"

/* Where a direct buffer is; arrays move, and have no address that lasts. */
JNIEXPORT jlong JNICALL Java_vesica_Shapes_address(JNIEnv* env, jclass type, jobject buffer) {
  (void)type;
  return (jlong)(intptr_t)(*env)->GetDirectBufferAddress(env, buffer);
}
