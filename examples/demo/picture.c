// SPDX-License-Identifier: Apache-2.0
#include "picture.h"

// Pixels.
enum { columns = 8, margin = 16, heading = 74, section = 34 };

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
    ".p{fill:#fff}.i,.l,.g{fill:none;stroke:#111}.i,.l{stroke-width:.8}.g{stroke-width:2}\n"
    ".s{font-size:10px;font-weight:bold;fill:#111;stroke:#fff;stroke-width:3;paint-order:stroke}\n"
    "</style>\n";

static const char* const titles[look_count] = {"Apart, by a gap too small to see",
                                               "Overlapping, by a depth too small to see",
                                               "Touching exactly, which counts as overlap", "Plain to see"};

static int count_shown(const struct picture* picture) {
  return picture->pairs < picture_capacity ? (int)picture->pairs : picture_capacity;
}

// The panel that shows the pair: the newest one or a new one.
static struct panel* find_panel(struct picture* picture, const struct pair* pair) {
  const long newest = picture->pairs <= picture_capacity ? picture->pairs - 1 : picture_capacity;
  struct panel* next;
  if (newest >= 0 && shows_pair(&picture->panels[newest], pair)) return &picture->panels[newest];
  next = &picture->panels[count_shown(picture)];
  fill_panel(next, pair);
  picture->pairs++;
  return next;
}

void add_question(struct picture* picture, const struct pair* pair, double answer, int wrong) {
  picture->questions++;
  add_answer(find_panel(picture, pair), pair, answer, wrong);
}

static int section_height(const struct picture* picture, int look) {
  int panels = 0;
  for (int i = 0; i < count_shown(picture); i++) panels += (int)picture->panels[i].look == look;
  return panels > 0 ? section + (panels + columns - 1) / columns * panel_height : 0;
}

static void write_key(FILE* file, int x, const char* css_class, const char* text) {
  fprintf(file, "<path class=\"%s\" d=\"M%d 44h14v12h-14Z\"/><text class=\"k\" x=\"%d\" y=\"55\">%s</text>\n",
          css_class, x, x + 19, text);
}

static void write_heading(FILE* file, const struct picture* picture) {
  const int x = margin;
  fprintf(file, "<text class=\"h\" x=\"%d\" y=\"28\">%ld %s about %ld %s of shapes", x, picture->questions,
          picture->questions == 1 ? "question" : "questions", picture->pairs, picture->pairs == 1 ? "pair" : "pairs");
  if (picture->pairs > picture_capacity) fprintf(file, ", the first %d drawn", picture_capacity);
  fprintf(file, "</text>\n<text class=\"k\" x=\"%d\" y=\"55\">Overlap:</text>\n", x);
  write_key(file, x + 64, "oa", "first shape");
  write_key(file, x + 168, "ob", "second shape");
  fprintf(file, "<text class=\"k\" x=\"%d\" y=\"55\">Apart:</text>\n", x + 310);
  write_key(file, x + 358, "aa", "first shape");
  write_key(file, x + 462, "ab", "second shape");
  write_key(file, x + 604, "i", "magnified: the number is the length of the thick line");
}

// A title, and the panels of that look, if there are any.
static void write_section(FILE* file, const struct picture* picture, int look, int top) {
  int written = 0;
  fprintf(file, "<text class=\"h\" x=\"%d\" y=\"%d\">%s</text>\n", margin, top + 22, titles[look]);
  for (int i = 0; i < count_shown(picture); i++) {
    const struct panel* panel = &picture->panels[i];
    if ((int)panel->look != look) continue;
    write_panel(file, panel, margin + written % columns * panel_width,
                top + section + written / columns * panel_height);
    written++;
  }
}

void write_picture(FILE* file, const struct picture* picture) {
  const int width = 2 * margin + columns * panel_width;
  int height = heading + margin, top = heading;
  for (int look = 0; look < look_count; look++) height += section_height(picture, look);
  fputs("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n", file);
  fprintf(file, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\">\n", width,
          height, width, height);
  fputs(style, file);
  fprintf(file, "<rect width=\"%d\" height=\"%d\" fill=\"#f7f7f5\"/>\n", width, height);
  write_heading(file, picture);
  for (int look = 0; look < look_count; look++) {
    const int taken = section_height(picture, look);
    if (taken > 0) write_section(file, picture, look, top);
    top += taken;
  }
  fputs("</svg>\n", file);
}
