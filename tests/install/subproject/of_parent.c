/* SPDX-License-Identifier: Apache-2.0 */
/* A library of the parent's own: whether it is shared is for the parent to say. */
int of_parent(void);
int of_parent(void) { return 0; }
