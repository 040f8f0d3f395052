// SPDX-License-Identifier: Apache-2.0
#include "picture.h"

#include <string.h>
#include <vesica.h>

#include "line.h"
#include "outline.h"

// Pixels.
enum { columns = 8, margin = 16, heading = 60, panel_width = 168, panel_height = 190, drawing = 136, inset = 10 };

static const char style[] =
    "<style>\n"
    "text{font-family:'DejaVu Sans',Verdana,sans-serif;fill:#222}\n"
    ".h{font-size:18px}.k{font-size:12px}.c{font-size:9px}.d{font-size:9px;fill:#666}\n"
    ".f{fill:#fff;stroke:#ddd}.w{fill:#fff4c2;stroke:#b00;stroke-width:3}\n"
    "path,circle{stroke-width:1.2;stroke-linejoin:round;fill-opacity:.32}\n"
    // Colours that red-green blindness keeps apart.
    ".oa{fill:#d55e00;stroke:#a33c00}.ob{fill:#e8485a;stroke:#8c1326}\n"
    ".aa{fill:#0072b2;stroke:#00517f}.ab{fill:#8a95a0;stroke:#4e5963}\n"
    "</style>\n";

void add_panel(struct picture* picture, const struct pair* pair, int overlap, int wrong) {
  if (picture->pairs < picture_capacity) {
    struct panel* panel = &picture->panels[picture->pairs];
    panel->pair = *pair;
    panel->overlap = overlap;
    panel->wrong = wrong;
  }
  picture->pairs++;
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

static void write_shapes(FILE* file, const struct panel* panel, double left, double top) {
  struct view view;
  if (find_view(&panel->pair, left, top, drawing, &view) != 0) {
    fprintf(file, "<text class=\"d\" x=\"%.2f\" y=\"%.2f\">too large to draw</text>\n", left, top + drawing / 2.0);
    return;
  }
  write_shape(file, &panel->pair.a, &view, panel->overlap ? "oa" : "aa");
  write_shape(file, &panel->pair.b, &view, panel->overlap ? "ob" : "ab");
}

static void write_caption(FILE* file, const struct panel* panel, double x, double y) {
  const struct pair* pair = &panel->pair;
  fprintf(file, "<text class=\"c\" x=\"%.2f\" y=\"%.2f\">", x, y);
  put_id(file, pair->id);
  fprintf(file, "</text>\n<text class=\"d\" x=\"%.2f\" y=\"%.2f\">%s, %s: %s%s</text>\n", x, y + 13,
          vesica_kind_name(pair->a.kind), vesica_kind_name(pair->b.kind), panel->overlap ? "overlap" : "apart",
          panel->wrong ? " (WRONG)" : "");
}

static void write_panel(FILE* file, const struct panel* panel, int left, int top) {
  fputs("<g><title>", file);
  put_escaped(file, panel->pair.id, sizeof panel->pair.id);
  fputs("\n", file);
  put_numbers(file, &panel->pair.a);
  fputs("\n", file);
  put_numbers(file, &panel->pair.b);
  fprintf(file, "</title>\n<rect class=\"%s\" x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" rx=\"4\"/>\n",
          panel->wrong ? "w" : "f", left, top, panel_width - 8, panel_height - 8);
  write_shapes(file, panel, left + (panel_width - 8 - drawing) / 2.0, top + inset);
  write_caption(file, panel, left + inset, top + inset + drawing + 18);
  fputs("</g>\n", file);
}

static void write_heading(FILE* file, const struct picture* picture, int shown) {
  fprintf(file, "<text class=\"h\" x=\"%d\" y=\"30\">", margin);
  if (shown < picture->pairs) fprintf(file, "The first %d of ", shown);
  fprintf(file, "%ld %s</text>\n", picture->pairs, picture->pairs == 1 ? "pair" : "pairs");
  fprintf(file,
          "<circle class=\"oa\" cx=\"%d\" cy=\"46\" r=\"5\"/><text class=\"k\" x=\"%d\" y=\"50\">overlap</text>\n",
          margin + 6, margin + 16);
  fprintf(file, "<circle class=\"aa\" cx=\"%d\" cy=\"46\" r=\"5\"/><text class=\"k\" x=\"%d\" y=\"50\">apart</text>\n",
          margin + 96, margin + 106);
}

void write_picture(FILE* file, const struct picture* picture) {
  const int shown = picture->pairs < picture_capacity ? (int)picture->pairs : picture_capacity;
  const int across = shown < 1 ? 1 : shown < columns ? shown : columns;
  const int down = (shown + columns - 1) / columns;
  // Room for the heading beside a single panel.
  const int width = 2 * margin + (across < 2 ? 2 : across) * panel_width;
  const int height = heading + margin + down * panel_height;
  fputs("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n", file);
  fprintf(file, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\">\n", width,
          height, width, height);
  fputs(style, file);
  fprintf(file, "<rect width=\"%d\" height=\"%d\" fill=\"#f7f7f5\"/>\n", width, height);
  write_heading(file, picture, shown);
  for (int i = 0; i < shown; i++) {
    write_panel(file, &picture->panels[i], margin + i % columns * panel_width, heading + i / columns * panel_height);
  }
  fputs("</svg>\n", file);
}
