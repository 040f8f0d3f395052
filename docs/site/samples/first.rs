extern "C" {
    fn vesica_overlap_f64(kind_a: i32, a: *const f64, kind_b: i32, b: *const f64) -> i32;
    fn vesica_nearest_f64(kind_a: i32, a: *const f64, kind_b: i32, b: *const f64, out: *mut [f64; 5]) -> i32;
    fn vesica_iou_f64(kind_a: i32, a: *const f64, kind_b: i32, b: *const f64, out: *mut f64) -> i32;
}
const CIRCLE: i32 = 2;
const RECT: i32 = 4;
const ELLIPSE: i32 = 5;

fn main() {
    let car = [0.0, 0.0, 0.8, 0.6, 2.0, 1.0];
    let person = [1.5, 1.0, 1.0, 0.0, 1.0, 0.5];
    let post = [5.0, 0.0, 0.5];
    let (mut gap, mut iou) = ([0.0; 5], 0.0); // the distance, and a point of each

    let hit = unsafe { vesica_overlap_f64(RECT, car.as_ptr(), ELLIPSE, person.as_ptr()) };
    let near = unsafe { vesica_nearest_f64(RECT, car.as_ptr(), CIRCLE, post.as_ptr(), &mut gap) };
    let both = unsafe { vesica_iou_f64(RECT, car.as_ptr(), ELLIPSE, person.as_ptr(), &mut iou) };
    assert!(hit >= 0 && near >= 0 && both >= 0, "an error, as vesica_strerror names it");
    println!("overlap {hit}, distance {:.6}, IoU {iou:.6}", gap[0]);
}
