use serde::{Deserialize, Serialize};

use crate::{
    Colour, Role,
    palette::{DARK, LIGHT, Palette},
    ramp::share_of_run,
};

/// Which ground the picture stands on. Every colour of every picture comes from here.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Theme {
    /// Dark lines on light paper: print and projectors.
    #[default]
    Light,
    /// Light lines on a dark ground.
    Dark,
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Its colour.
    pub colour: Colour,
    /// Pixels.
    pub width: f64,
}

/// The sign that marks a single place; its size does not depend on the scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sign {
    /// A round dot of that radius, pixels.
    Dot(f64),
    /// A square on its corner.
    Diamond(f64),
    /// A triangle on its base.
    Triangle(f64),
    /// A square on its side.
    Square(f64),
    /// A house.
    House(f64),
}

/// How a thing is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// What its area is filled with.
    pub fill: Option<Colour>,
    /// What its outline is drawn with.
    pub stroke: Option<Stroke>,
    /// What marks its points, where it is a set of points.
    pub sign: Sign,
    /// Whether its lines are dashed.
    pub dashed: bool,
}

impl Theme {
    pub(crate) fn palette(self) -> &'static Palette {
        match self {
            Self::Light => &LIGHT,
            Self::Dark => &DARK,
        }
    }

    /// The ground of the picture.
    #[must_use]
    pub fn paper(self) -> Colour {
        Colour::solid(self.palette().paper)
    }

    /// The colour of the surfaces that a view saw first, a share of the way through the run.
    #[must_use]
    pub fn of_run(self, share: f64) -> Colour {
        self.palette().ramp.at(share)
    }

    /// The colour of a local space, by its number; after a while the colours come again.
    #[must_use]
    pub fn of_asr(self, number: u32) -> Colour {
        let colours = self.palette().asrs;
        Colour::solid(colours[number as usize % colours.len()])
    }

    /// The colour of what was first seen a share of the run ago; 0 is now.
    #[must_use]
    pub fn of_age(self, share: f64) -> Colour {
        let palette = self.palette();
        Colour::solid(palette.ink).towards(Colour::solid(palette.truth), share)
    }

    /// What a thing looks like in a run of `views` views, at so many pixels a metre.
    #[must_use]
    pub fn style(self, role: Role, views: usize, pixels_per_metre: f64) -> Style {
        let palette = self.palette();
        let share = |view: usize| share_of_run(view, views);
        let share_of_age = |age: u32| f64::from(age) / f64::from(views.max(2).ilog2());
        let solid = Colour::solid;
        match role {
            Role::Room => Style::area(solid(palette.room), None),
            Role::RoomLabel => Style::area(solid(palette.muted), None),
            Role::Wall => Style::line(solid(palette.ink), (pixels_per_metre * 0.05).clamp(1.25, 3.0)),
            Role::Furniture => {
                Style::area(solid(palette.furniture), Some((solid(palette.furniture_edge), 1.0)))
            }
            Role::Door => Style::line(solid(palette.door), (pixels_per_metre * 0.05).clamp(1.5, 3.0)),
            Role::DoorSwing => Style::line(solid(palette.door).with_alpha(96), 1.0),
            Role::Person => Style::points(solid(palette.person), Sign::Dot(5.0)),
            Role::TruePath => Style::line(solid(palette.robot).with_alpha(170), 1.5),
            Role::Robot => Style::area(solid(palette.robot), Some((solid(palette.room), 1.5))),
            Role::LaserFan => Style::area(solid(palette.laser).with_alpha(28), None),
            Role::LaserHit => Style::points(solid(palette.laser), Sign::Dot(1.25)),
            Role::Truth => Style::line(solid(palette.truth), 1.0),
            Role::SurfaceOfView(view) => Style::surface(self.of_run(share(view)), pixels_per_metre),
            Role::DebrisOfView(view) => Style::debris(self.of_run(share(view))),
            Role::SurfaceOfAge(age) => Style::surface(self.of_age(share_of_age(age)), pixels_per_metre),
            Role::DebrisOfAge(age) => Style::debris(self.of_age(share_of_age(age))),
            Role::Place(mark) => mark.style(self, pixels_per_metre),
            Role::Homing(mark) => mark.style(palette),
            Role::SeenNow => Style::line(solid(palette.robot).with_alpha(90), 6.0),
            Role::ReferenceKnown => Style::line(solid(palette.reference).with_alpha(90), 9.0),
            Role::ReferenceSeen => Style::line(solid(palette.reference), 2.0),
            Role::Path => Style::line(solid(palette.muted).with_alpha(200), 1.0),
            Role::PathStep => {
                Style::points(solid(palette.muted), Sign::Dot((pixels_per_metre * 0.03).clamp(0.5, 1.75)))
            }
            Role::WeakPlacement => Style::points(solid(palette.warning), Sign::Diamond(4.5)).hollow(palette),
            Role::FallbackPlacement => Style::points(solid(palette.warning), Sign::Triangle(4.5)),
            Role::Annotation(annotation) => annotation.style(palette),
            Role::BelievedRobot => {
                Style::area(solid(palette.room).with_alpha(150), Some((solid(palette.robot), 2.0)))
            }
        }
    }
}

impl Style {
    pub(crate) fn line(colour: Colour, width: f64) -> Self {
        Self { fill: None, stroke: Some(Stroke { colour, width }), sign: Sign::Dot(width), dashed: false }
    }

    pub(crate) fn area(fill: Colour, edge: Option<(Colour, f64)>) -> Self {
        let stroke = edge.map(|(colour, width)| Stroke { colour, width });
        Self { fill: Some(fill), stroke, sign: Sign::Dot(1.0), dashed: false }
    }

    pub(crate) fn points(fill: Colour, sign: Sign) -> Self {
        Self { fill: Some(fill), stroke: None, sign, dashed: false }
    }

    /// The same in dashes.
    pub(crate) fn dashed(self) -> Self {
        Self { dashed: true, ..self }
    }

    /// A wall as a memory holds it.
    pub(crate) fn surface(colour: Colour, pixels_per_metre: f64) -> Self {
        Self::line(colour, (pixels_per_metre * 0.04).clamp(1.0, 2.5))
    }

    /// A surface too short to say much.
    pub(crate) fn debris(colour: Colour) -> Self {
        Self::line(colour, 0.75)
    }

    fn hollow(self, palette: &Palette) -> Self {
        let stroke = self.fill.map(|colour| Stroke { colour, width: 1.5 });
        Self { fill: Some(Colour::solid(palette.paper)), stroke, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cogmap_geometry::trig;

    fn linear(colour: Colour) -> [f64; 3] {
        colour.rgb.map(|byte| {
            let share = f64::from(byte) / 255.0;
            if share <= 0.040_45 { share / 12.92 } else { trig::pow((share + 0.055) / 1.055, 2.4) }
        })
    }

    /// WCAG 2, relative luminance and contrast ratio.
    fn contrast(one: Colour, other: Colour) -> f64 {
        let luminance = |colour| {
            let [r, g, b] = linear(colour);
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        let (one, other) = (luminance(one), luminance(other));
        (one.max(other) + 0.05) / (one.min(other) + 0.05)
    }

    /// OKLab (Ottosson 2020): distances are about as large as they look.
    fn oklab(colour: Colour) -> [f64; 3] {
        oklab_of(linear(colour))
    }

    fn oklab_of([r, g, b]: [f64; 3]) -> [f64; 3] {
        let root = |value: f64| trig::pow(value, 1.0 / 3.0);
        let l = root(0.412_221_470_8 * r + 0.536_332_536_3 * g + 0.051_445_992_9 * b);
        let m = root(0.211_903_498_2 * r + 0.680_699_545_1 * g + 0.107_396_956_6 * b);
        let s = root(0.088_302_461_9 * r + 0.281_718_837_6 * g + 0.629_978_700_5 * b);
        [
            0.210_454_255_3 * l + 0.793_617_785_0 * m - 0.004_072_046_8 * s,
            1.977_998_495_1 * l - 2.428_592_205_0 * m + 0.450_593_709_9 * s,
            0.025_904_037_1 * l + 0.782_771_766_2 * m - 0.808_675_766_0 * s,
        ]
    }

    /// What those see who lack the cones for red or for green (Machado, Oliveira and Fernandes 2009).
    const EYES: [[[f64; 3]; 3]; 3] = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [
            [0.152_286, 1.052_583, -0.204_868],
            [0.114_503, 0.786_281, 0.099_216],
            [-0.003_882, -0.048_116, 1.051_998],
        ],
        [
            [0.367_322, 0.860_646, -0.227_968],
            [0.280_085, 0.672_501, 0.047_413],
            [-0.011_820, 0.042_940, 0.968_881],
        ],
    ];

    fn run(theme: Theme) -> Vec<Colour> {
        (0..=16).map(|i| theme.of_run(f64::from(i) / 16.0)).collect()
    }

    const THEMES: [Theme; 2] = [Theme::Light, Theme::Dark];

    #[test]
    fn every_view_stands_out_from_the_ground() {
        for theme in THEMES {
            for i in 0..=200 {
                let colour = theme.of_run(f64::from(i) / 200.0);
                assert!(contrast(colour, theme.paper()) >= 3.0, "{theme:?} {i}: {}", colour.css());
            }
        }
    }

    #[test]
    fn every_eye_tells_local_spaces_apart() {
        for theme in THEMES {
            let colours: Vec<_> = (0..8).map(|number| theme.of_asr(number)).collect();
            for (index, one) in colours.iter().enumerate() {
                assert!(contrast(*one, theme.paper()) >= 3.0, "{theme:?} {}", one.css());
                for (other, eye) in colours[..index].iter().flat_map(|other| EYES.map(|eye| (other, eye))) {
                    let [one, other] = [*one, *other].map(|colour| oklab_of(seen_by(eye, linear(colour))));
                    let squares = one.iter().zip(other).map(|(a, b)| (a - b) * (a - b));
                    let apart = squares.sum::<f64>().sqrt();
                    assert!(apart >= 0.1, "{theme:?}: {index} is {apart} from another");
                }
            }
        }
    }

    fn seen_by(eye: [[f64; 3]; 3], colour: [f64; 3]) -> [f64; 3] {
        eye.map(|row| row.iter().zip(colour).map(|(a, b)| a * b).sum::<f64>().clamp(0.0, 1.0))
    }

    #[test]
    fn later_views_are_lighter_in_even_steps() {
        for theme in THEMES {
            let labs: Vec<_> = run(theme).into_iter().map(oklab).collect();
            for pair in labs.windows(2) {
                let ([l0, a0, b0], [l1, a1, b1]) = (pair[0], pair[1]);
                let step = ((l1 - l0) * (l1 - l0) + (a1 - a0) * (a1 - a0) + (b1 - b0) * (b1 - b0)).sqrt();
                assert!((0.03..0.05).contains(&step), "{theme:?}: {step}");
                assert!(l1 - l0 > 0.005, "{theme:?}: lightness rises by {}", l1 - l0);
            }
        }
    }

    #[test]
    fn words_and_marks_can_be_read() {
        for theme in THEMES {
            let palette = theme.palette();
            for ground in [palette.paper, palette.room].map(Colour::solid) {
                for text in [palette.ink, palette.muted] {
                    assert!(contrast(Colour::solid(text), ground) >= 4.5, "{theme:?} {text:06x}");
                }
                for mark in [
                    palette.door,
                    palette.person,
                    palette.laser,
                    palette.robot,
                    palette.reference,
                    palette.warning,
                    palette.added,
                    palette.homeward,
                ] {
                    assert!(contrast(Colour::solid(mark), ground) >= 3.0, "{theme:?} {mark:06x}");
                }
            }
        }
    }
}
