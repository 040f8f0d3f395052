// SPDX-License-Identifier: Apache-2.0
#include "panel.h"

#include <math.h>
#include <string.h>
#include <vesica.h>

#include "inset.h"
#include "line.h"
#include "query.h"
#include "view.h"

// Pixels.
enum { gutter = 8, border = 10 };

static int relation_is_touch(const struct pair* pair) {
  const int32_t relation = vesica_relation_f64(pair->a.kind, pair->a.numbers, pair->b.kind, pair->b.numbers);
  return relation == VESICA_TOUCH || relation == VESICA_INSIDE_TOUCH || relation == VESICA_CONTAINS_TOUCH;
}

static enum look find_look(const struct panel* panel) {
  const double visible = 1.5;  // pixels
  struct view view;
  if (find_view(&panel->pair, 0, 0, &view) != 0 || !(panel->size * view.scale < visible)) return look_plain;
  if (!panel->overlap) return look_apart_close;
  if (panel->size > 0) return look_overlap_close;
  return relation_is_touch(&panel->pair) ? look_touch : look_plain;
}

void fill_panel(struct panel* panel, const struct pair* pair) {
  const struct shape *a = &pair->a, *b = &pair->b;
  memset(panel, 0, sizeof *panel);
  panel->pair = *pair;
  panel->overlap = vesica_overlap_f64(a->kind, a->numbers, b->kind, b->numbers) == 1;
  panel->size = INFINITY;
  find_query(panel->overlap ? "depth" : "distance")->answer(pair, &panel->size);
  panel->look = find_look(panel);
}

void add_answer(struct panel* panel, const struct pair* pair, double answer, int wrong) {
  const size_t used = strlen(panel->answers);
  char text[48];
  panel->wrong |= wrong;
  if (pair->query->yes_no) return;
  snprintf(text, sizeof text, "%s %.7g", pair->query->name, answer);
  if (strstr(panel->answers, text)) return;
  snprintf(panel->answers + used, sizeof panel->answers - used, "%s%s", used > 0 ? ", " : "", text);
}

static int same_shape(const struct shape* a, const struct shape* b) {
  int same = a->kind == b->kind;
  for (int i = 0; same && i < vesica_field_count(a->kind); i++) same = a->numbers[i] == b->numbers[i];
  return same;
}

int shows_pair(const struct panel* panel, const struct pair* pair) {
  return (same_shape(&panel->pair.a, &pair->a) && same_shape(&panel->pair.b, &pair->b)) ||
         (same_shape(&panel->pair.a, &pair->b) && same_shape(&panel->pair.b, &pair->a));
}

static void write_drawing(FILE* file, const struct panel* panel, double left, double top) {
  struct view view;
  if (find_view(&panel->pair, left, top, &view) != 0) {
    fprintf(file, "<text class=\"d\" x=\"%.2f\" y=\"%.2f\">too large to draw</text>\n", left, top + drawing / 2.0);
    return;
  }
  write_shape(file, &panel->pair.a, &view, panel->overlap ? "oa" : "aa");
  write_shape(file, &panel->pair.b, &view, panel->overlap ? "ob" : "ab");
  if (panel->look != look_plain) write_inset(file, &panel->pair, panel->overlap, &view);
}

// Writes the first `limit` characters, or fewer if the text ends.
static void put_escaped(FILE* file, const char* text, size_t limit) {
  char shown[2] = {0, 0};
  for (; limit > 0 && *text; text++, limit--) {
    switch (*text) {
      case '&':
        fputs("&amp;", file);
        break;
      case '<':
        fputs("&lt;", file);
        break;
      case '>':
        fputs("&gt;", file);
        break;
      default:
        shown[0] = *text;
        put_printable(file, shown, 1);
    }
  }
}

// An id that is too long for a panel loses its middle: its end often counts the cases of one source.
static void put_id(FILE* file, const char* id) {
  const size_t most = 26, head = 15, tail = 8, length = strlen(id);
  put_escaped(file, id, length <= most ? most : head);
  if (length <= most) return;
  fputs("...", file);
  put_escaped(file, id + length - tail, tail);
}

static void put_numbers(FILE* file, const struct shape* shape) {
  fputs(vesica_kind_name(shape->kind), file);
  for (int i = 0; i < vesica_field_count(shape->kind); i++) fprintf(file, " %.17g", shape->numbers[i]);
}

static void put_verdict(FILE* file, const struct panel* panel) {
  fputs(panel->look == look_touch ? "touch: overlap" : panel->overlap ? "overlap" : "apart", file);
  if (panel->look == look_apart_close || panel->look == look_overlap_close) fprintf(file, " by %.3g", panel->size);
  if (panel->wrong) fputs(" (WRONG)", file);
}

static void begin_text(FILE* file, const char* css_class, double x, double y) {
  fprintf(file, "<text class=\"%s\" x=\"%.2f\" y=\"%.2f\">", css_class, x, y);
}

static void write_caption(FILE* file, const struct panel* panel, double x, double y) {
  // Characters. Where all answers are longer only the first is shown; the title has them all.
  const size_t most = 28, length = strlen(panel->answers);
  const char *kind_a = vesica_kind_name(panel->pair.a.kind), *kind_b = vesica_kind_name(panel->pair.b.kind);
  begin_text(file, panel->overlap ? "vo" : "va", x, y);
  put_verdict(file, panel);
  fputs("</text>\n", file);
  begin_text(file, "d", x, y + 13);
  fprintf(file, "%s, %s</text>\n", kind_a, kind_b);
  begin_text(file, "d", x, y + 25);
  fprintf(file, "%.*s</text>\n", (int)(length <= most ? length : strcspn(panel->answers, ",")), panel->answers);
  begin_text(file, "d", x, y + 37);
  put_id(file, panel->pair.id);
  fputs("</text>\n", file);
}

void write_panel(FILE* file, const struct panel* panel, int left, int top) {
  fputs("<g><title>", file);
  put_escaped(file, panel->pair.id, sizeof panel->pair.id);
  fputs("\n", file);
  put_numbers(file, &panel->pair.a);
  fputs("\n", file);
  put_numbers(file, &panel->pair.b);
  fprintf(file, "\n%s", panel->answers);
  fprintf(file, "</title>\n<rect class=\"%s\" x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" rx=\"4\"/>\n",
          panel->wrong ? "w" : "f", left, top, panel_width - gutter, panel_height - gutter);
  write_drawing(file, panel, left + (panel_width - gutter - drawing) / 2.0, top + border);
  write_caption(file, panel, left + border, top + border + drawing + 18);
  fputs("</g>\n", file);
}
