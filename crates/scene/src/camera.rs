use cogmap_geometry::DVec2;
use serde::{Deserialize, Serialize};

/// A rectangle along the axes, metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Its lower left corner.
    pub min: DVec2,
    /// Its upper right corner.
    pub max: DVec2,
}

impl Bounds {
    /// The rectangle grown to hold `point`; points that are not finite leave it as it is.
    #[must_use]
    pub fn around(bounds: Option<Self>, point: DVec2) -> Option<Self> {
        if !point.is_finite() {
            return bounds;
        }
        let Self { min, max } = bounds.unwrap_or(Self { min: point, max: point });
        Some(Self { min: min.min(point), max: max.max(point) })
    }

    /// The smallest rectangle that holds both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// The point half-way.
    #[must_use]
    pub fn center(self) -> DVec2 {
        (self.min + self.max) * 0.5
    }
}

/// Pixels kept free around the map.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Margins {
    /// Above, pixels.
    pub top: f64,
    /// Below, pixels.
    pub bottom: f64,
    /// On either side, pixels.
    pub side: f64,
}

/// Which part of the plane the picture shows. Pixels count from the upper left corner, y down.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Camera {
    /// The point in the middle of the picture, metres.
    pub center: DVec2,
    /// The scale.
    pub pixels_per_metre: f64,
}

impl Camera {
    /// The scales that make sense: a town on a telephone, a screw on a projector.
    pub const SCALES: core::ops::RangeInclusive<f64> = 0.5..=2000.0;

    /// The largest view of `bounds` within a picture of that size, in pixels; at most 100 pixels a
    /// metre, so that a single wall does not fill the picture.
    #[must_use]
    pub fn fit(bounds: Bounds, width: f64, height: f64, margins: Margins) -> Self {
        let free = DVec2::new(width - 2.0 * margins.side, height - margins.top - margins.bottom);
        let size = (bounds.max - bounds.min).max(DVec2::splat(0.01));
        let scale = (free.max(DVec2::ONE) / size).min_element().min(100.0);
        let pixels_per_metre = clamp_scale(scale);
        let down = (margins.top - margins.bottom) * 0.5;
        Self { center: bounds.center() + DVec2::new(0.0, down / pixels_per_metre), pixels_per_metre }
    }

    /// Where a point of the plane appears in a picture of that size.
    #[must_use]
    pub fn to_pixels(self, point: DVec2, width: f64, height: f64) -> DVec2 {
        let offset = (point - self.center) * self.pixels_per_metre;
        DVec2::new(width * 0.5 + offset.x, height * 0.5 - offset.y)
    }

    /// Which point of the plane appears at a pixel.
    #[must_use]
    pub fn to_metres(self, pixel: DVec2, width: f64, height: f64) -> DVec2 {
        let offset = DVec2::new(pixel.x - width * 0.5, height * 0.5 - pixel.y);
        self.center + offset / self.pixels_per_metre
    }

    /// The view after the picture was dragged by so many pixels.
    #[must_use]
    pub fn dragged(self, by: DVec2) -> Self {
        let center = self.center + DVec2::new(-by.x, by.y) / self.pixels_per_metre;
        Self { center, ..self }
    }

    /// The view after zooming in by a factor, with the point of the plane at `held` staying there.
    #[must_use]
    pub fn zoomed(self, factor: f64, held: DVec2) -> Self {
        let pixels_per_metre = clamp_scale(self.pixels_per_metre * factor);
        let center = held + (self.center - held) * (self.pixels_per_metre / pixels_per_metre);
        Self { center, pixels_per_metre }
    }
}

fn clamp_scale(scale: f64) -> f64 {
    if scale.is_nan() { 50.0 } else { scale.clamp(*Camera::SCALES.start(), *Camera::SCALES.end()) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    prop_compose! {
        fn any_point()(x in -50.0f64..50.0, y in -50.0f64..50.0) -> DVec2 { DVec2::new(x, y) }
    }

    prop_compose! {
        fn any_camera()(center in any_point(), pixels_per_metre in 1.0f64..500.0) -> Camera {
            Camera { center, pixels_per_metre }
        }
    }

    proptest! {
        #[test]
        fn a_pixel_leads_back_to_its_point(camera in any_camera(), point in any_point()) {
            let pixel = camera.to_pixels(point, 640.0, 480.0);
            prop_assert!(camera.to_metres(pixel, 640.0, 480.0).distance(point) < 1e-9);
        }

        #[test]
        fn zooming_holds_its_point(camera in any_camera(), held in any_point(), factor in 0.5f64..2.0) {
            let before = camera.to_pixels(held, 640.0, 480.0);
            let after = camera.zoomed(factor, held).to_pixels(held, 640.0, 480.0);
            prop_assert!(before.distance(after) < 1e-6);
        }

        #[test]
        fn dragging_moves_every_point_alike(camera in any_camera(), point in any_point(), by in any_point()) {
            let before = camera.to_pixels(point, 640.0, 480.0);
            let after = camera.dragged(by).to_pixels(point, 640.0, 480.0);
            prop_assert!((after - before).distance(by) < 1e-6);
        }

        #[test]
        fn what_was_fitted_lies_within_the_margins(a in any_point(), b in any_point()) {
            let bounds = Bounds { min: a.min(b), max: a.max(b) };
            let margins = Margins { top: 50.0, bottom: 80.0, side: 20.0 };
            let camera = Camera::fit(bounds, 640.0, 480.0, margins);
            for corner in [bounds.min, bounds.max] {
                let pixel = camera.to_pixels(corner, 640.0, 480.0);
                prop_assert!((19.99..=620.01).contains(&pixel.x));
                prop_assert!((49.99..=400.01).contains(&pixel.y));
            }
        }
    }

    #[test]
    fn bounds_ignore_what_is_not_finite() {
        let bounds = Bounds::around(None, DVec2::new(1.0, 2.0));
        assert_eq!(Bounds::around(bounds, DVec2::new(f64::NAN, 0.0)), bounds);
        assert_eq!(Bounds::around(None, DVec2::new(f64::INFINITY, 0.0)), None);
    }
}
