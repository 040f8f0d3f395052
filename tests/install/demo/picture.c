// SPDX-License-Identifier: Apache-2.0
#include "picture.h"

// Pixels.
enum { columns = 8, margin = 16, heading = 64, section = 34 };

static const char style[] =
    "<style>\n"
    "text{font-family:'DejaVu Sans',Verdana,sans-serif;fill:#222}\n"
    ".h{font-size:18px;font-weight:bold}.k{font-size:12px}.d{font-size:9px;fill:#666}\n"
    ".vo,.va{font-size:12px;font-weight:bold}.vo{fill:#a33c00}.va{fill:#00517f}\n"
    ".f{fill:#fff;stroke:#ddd}.w{fill:#fff4c2;stroke:#b00;stroke-width:3}\n"
    "path,circle{stroke-width:1.2;stroke-linejoin:round;fill-opacity:.32}\n"
    // Colours that red-green blindness keeps apart.
    ".oa{fill:#d55e00;stroke:#a33c00}.ob{fill:#e8485a;stroke:#8c1326}\n"
    ".aa{fill:#0072b2;stroke:#00517f}.ab{fill:#8a95a0;stroke:#4e5963}\n"
    ".i,.l,.g{fill:none;stroke:#111}.i,.l{stroke-width:.8}.g{stroke-width:2}\n"
    "</style>\n";

void add_panel(struct picture* picture, const struct pair* pair, double answer, int wrong) {
  if (picture->pairs < picture_capacity) fill_panel(&picture->panels[picture->pairs], pair, answer, wrong);
  picture->pairs++;
}

static int count_shown(const struct picture* picture) {
  return picture->pairs < picture_capacity ? (int)picture->pairs : picture_capacity;
}

static int count_close(const struct picture* picture) {
  int close = 0;
  for (int i = 0; i < count_shown(picture); i++) close += picture->panels[i].close;
  return close;
}

static int section_height(int panels) {
  return panels > 0 ? section + (panels + columns - 1) / columns * panel_height : 0;
}

static void write_key(FILE* file, int x, const char* css_class, const char* text) {
  fprintf(file, "<circle class=\"%s\" cx=\"%d\" cy=\"48\" r=\"6\"/><text class=\"k\" x=\"%d\" y=\"52\">%s</text>\n",
          css_class, x + 6, x + 17, text);
}

static void write_heading(FILE* file, const struct picture* picture) {
  const int shown = count_shown(picture);
  fprintf(file, "<text class=\"h\" x=\"%d\" y=\"28\">", margin);
  if (shown < picture->pairs) fprintf(file, "The first %d of ", shown);
  fprintf(file, "%ld %s</text>\n", picture->pairs, picture->pairs == 1 ? "pair" : "pairs");
  write_key(file, margin, "oa", "first shape,");
  write_key(file, margin + 96, "ob", "second: overlap");
  write_key(file, margin + 226, "aa", "first shape,");
  write_key(file, margin + 322, "ab", "second: apart");
}

// A title, and the panels that are close or not. Returns where the next section begins.
static int write_section(FILE* file, const struct picture* picture, int close, int panels, const char* title, int top) {
  int written = 0;
  if (panels == 0) return top;
  fprintf(file, "<text class=\"h\" x=\"%d\" y=\"%d\">%s</text>\n", margin, top + 22, title);
  for (int i = 0; i < count_shown(picture); i++) {
    if (picture->panels[i].close != close) continue;
    write_panel(file, &picture->panels[i], margin + written % columns * panel_width,
                top + section + written / columns * panel_height);
    written++;
  }
  return top + section_height(panels);
}

void write_picture(FILE* file, const struct picture* picture) {
  const int close = count_close(picture), plain = count_shown(picture) - close;
  const int width = 2 * margin + columns * panel_width;
  const int height = heading + section_height(close) + section_height(plain) + margin;
  int top = heading;
  fputs("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n", file);
  fprintf(file, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\">\n", width,
          height, width, height);
  fputs(style, file);
  fprintf(file, "<rect width=\"%d\" height=\"%d\" fill=\"#f7f7f5\"/>\n", width, height);
  write_heading(file, picture);
  top = write_section(file, picture, 1, close, "Too close to see: the place that decides is magnified", top);
  write_section(file, picture, 0, plain, close > 0 ? "Plain to see" : "", top);
  fputs("</svg>\n", file);
}
