#include <cstdio>
#include <vesica/vesica.hpp>

int main() {
  const vesica::Rect<double> car{0, 0, 0.8, 0.6, 2, 1};
  const vesica::Ellipse<double> person{1.5, 1, 1, 0, 1, 0.5};
  const vesica::Circle<double> post{5, 0, 0.5};

  std::printf("overlap %d, distance %.3f, IoU %.3f\n", vesica::overlap(car, person),
              vesica::nearest(car, post).distance, vesica::iou(car, person));
}
