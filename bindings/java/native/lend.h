/* SPDX-License-Identifier: Apache-2.0 */
/* Memory of Java's, lent to C for the time of a call: arrays stay where they are in the heap, and the collector waits
 * or pins them; direct buffers are where they are anyway. */
#ifndef VESICA_LEND_H
#define VESICA_LEND_H

#include <jni.h>
#include <vesica.h>

/* Returned if the JVM cannot lend an array; it has thrown an OutOfMemoryError. */
#define NOT_LENT VESICA_E_NULL
#define MAX_SETS 64
/* Local references to the bases of two indexes, and to the 16 objects that the machine has room for unasked. */
#define MAX_REFERENCES (2 * MAX_SETS + 16)

typedef struct {
  jobject array; /* or NULL */
  void* address;
} lent;

typedef struct {
  jint count, kinds[MAX_SETS];
  jlong counts[MAX_SETS], strides[MAX_SETS], steps[MAX_SETS];
  lent held[MAX_SETS];
} lent_sets;

/* First for all: while arrays are lent, nothing else may be asked of Java. Nor after a failure, which has thrown. */
static inline void prepare(JNIEnv* env, jobject object, lent* held) {
  held->address = object == NULL ? NULL : (*env)->GetDirectBufferAddress(env, object);
  held->array = held->address == NULL ? object : NULL;
}

static inline int prepare_sets(JNIEnv* env, jintArray kinds, jlongArray counts, jlongArray strides, jlongArray steps,
                               jobjectArray bases, lent_sets* sets) {
  const jint count = (*env)->GetArrayLength(env, kinds);
  if (count > MAX_SETS || (*env)->EnsureLocalCapacity(env, MAX_REFERENCES) != 0) return 0;
  (*env)->GetIntArrayRegion(env, kinds, 0, count, sets->kinds);
  (*env)->GetLongArrayRegion(env, counts, 0, count, sets->counts);
  (*env)->GetLongArrayRegion(env, strides, 0, count, sets->strides);
  (*env)->GetLongArrayRegion(env, steps, 0, count, sets->steps);
  for (jint i = 0; i < count; ++i) prepare(env, (*env)->GetObjectArrayElement(env, bases, i), &sets->held[i]);
  sets->count = count;
  return 1;
}

static inline int lend(JNIEnv* env, lent* held, jint count) {
  int all = 1;
  for (jint i = 0; i < count; ++i) {
    if (held[i].array == NULL) continue;
    held[i].address = (*env)->GetPrimitiveArrayCritical(env, held[i].array, NULL);
    all = all && held[i].address != NULL;
  }
  return all;
}

static inline void give_back(JNIEnv* env, lent* held, jint count) {
  for (jint i = count - 1; i >= 0; --i) {
    if (held[i].array == NULL || held[i].address == NULL) continue;
    (*env)->ReleasePrimitiveArrayCritical(env, held[i].array, held[i].address, 0);
  }
}

/* step bytes lie between the numbers of a shape. */
#define VIEW(view, kind_, count_, stride_, step_, base_, scalar)                                                 \
  do {                                                                                                           \
    (view).kind = (kind_), (view).reserved = 0, (view).count = (count_), (view).stride = (ptrdiff_t)(stride_);   \
    (view).rings = (view).polygons = NULL, (view).each = 0;                                                      \
    for (int k = 0; k < 8; ++k)                                                                                  \
      (view).field[k] = (base_) == NULL ? NULL : (const scalar*)((const char*)(base_) + k * (ptrdiff_t)(step_)); \
  } while (0)

#define SETS(views, lent, scalar)                                                                                 \
  for (jint i = 0; i < (lent).count; ++i)                                                                         \
  VIEW((views)[i], (lent).kinds[i], (lent).counts[i], (lent).strides[i], (lent).steps[i], (lent).held[i].address, \
       scalar)

#endif
