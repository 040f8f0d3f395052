/* SPDX-License-Identifier: Apache-2.0 */
/* A library older than every declaration in these folders: linked with all of the real one, whose vesica_version gives
 * way to this. */
#include <vesica.h>

int32_t vesica_version(void) { return 99; }
