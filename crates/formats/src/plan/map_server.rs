use super::yaml::Yaml;
use crate::FormatError;

/// Darkness below which a pixel is free, and above which it is occupied, where a file does not say it.
const FREE: f64 = 0.196;
const OCCUPIED: f64 = 0.65;

/// How a picture is to be read: what a ROS `map_server` file says of it.
#[derive(Clone, Debug, PartialEq)]
pub struct MapServer {
    /// The picture's file, from where the description lies.
    pub image: String,
    /// Edge of a pixel, metres.
    pub resolution: f64,
    /// Where the picture's lower left corner lies in the map: metres, metres, radians.
    pub origin: [f64; 3],
    /// Whether black is free, not white.
    pub negate: bool,
    /// A pixel is free where its darkness, from 0 to 1, lies below this.
    pub free_thresh: f64,
}

impl MapServer {
    /// Metres that a pixel may have, from and to.
    pub const RESOLUTIONS: [f64; 2] = [0.001, 10.0];

    /// A plain picture of which only the scale is known, metres a pixel.
    #[must_use]
    pub fn of_picture(image: &str, resolution: f64) -> Self {
        Self { image: image.to_owned(), resolution, origin: [0.0; 3], negate: false, free_thresh: FREE }
    }

    /// Reads a `map_server` YAML file. Keys that it does not need are passed over.
    ///
    /// ```
    /// use cogmap_formats::plan::MapServer;
    /// let text = "image: hall.pgm\nresolution: 0.05\norigin: [-3, -4.5, 0]  # metres\nnegate: 0\n";
    /// let map = MapServer::read(text, "hall.yaml").unwrap();
    /// assert_eq!((map.image.as_str(), map.resolution, map.origin), ("hall.pgm", 0.05, [-3.0, -4.5, 0.0]));
    ///
    /// let error = MapServer::read("image: hall.pgm\nresolutoin: 0.05\n", "hall.yaml").unwrap_err();
    /// assert!(error.to_string().contains("`resolution`"), "{error}");
    /// ```
    ///
    /// # Errors
    /// [`FormatError`] with the line and the way out.
    pub fn read(text: &str, file: &str) -> Result<Self, FormatError> {
        let yaml = Yaml::read(text, file)?;
        let image = yaml.text("image", "image: plan.png")?;
        let resolution = yaml.number("resolution", Self::RESOLUTIONS)?;
        let resolution = resolution.ok_or_else(|| yaml.missing("resolution", "resolution: 0.05"))?;
        let occupied = yaml.number("occupied_thresh", [0.0, 1.0])?.unwrap_or(OCCUPIED);
        let free_thresh = yaml.number("free_thresh", [0.0, 1.0])?.unwrap_or(FREE.min(occupied));
        if free_thresh > occupied {
            return Err(yaml.wrong("free_thresh", "lies above occupied_thresh"));
        }
        let origin = yaml.numbers("origin", [-10_000.0, 10_000.0])?.unwrap_or([0.0; 3]);
        let negate = yaml.switch("negate")?.unwrap_or(false);
        Ok(Self { image, resolution, origin, negate, free_thresh })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<MapServer, String> {
        MapServer::read(text, "hall.yaml").map_err(|error| error.to_string())
    }

    #[test]
    fn what_map_savers_write_is_understood() {
        let plain = read("image: a.pgm\nresolution: 0.05\norigin: [-1.5, 2, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n").unwrap();
        for text in [
            "%YAML 1.1\n---\nimage: \"a.pgm\" # it\nmode: trinary\nresolution: 5.0e-02\norigin:\n  - -1.5\n  - 2\n  - 0.0\nnegate: false\nfree_thresh: 0.25\n",
            "resolution: 0.05\r\nimage: 'a.pgm'\r\norigin: [ -1.5,2 , 0.0 ]\r\n\r\nfree_thresh: 0.25\r\n...\r\n",
        ] {
            assert_eq!(read(text).unwrap(), plain, "{text}");
        }
    }

    #[test]
    fn what_is_wrong_is_named_with_its_line() {
        for (text, told) in [
            ("resolution: 0.05\n", "no `image`"),
            ("image: a.png\n", "no `resolution`"),
            ("image: a.png\nresolution: fine\n", "line 2: `resolution` is \"fine\""),
            ("image: a.png\nresolution: -0.05\n", "line 2: `resolution` is \"-0.05\""),
            ("image: a.png\nresolution: nan\n", "line 2"),
            ("image: a.png\nresolution: 0.05\norigin: [0, 0]\n", "line 3: `origin`"),
            ("image: a.png\nresolution: 0.05\norigin: [0, 0, 0\n", "line 3"),
            ("image: a.png\nresolution: 0.05\norigin: [0, x, 0]\n", "line 3"),
            ("image: a.png\nresolution: 0.05\nnegate: maybe\n", "line 3: `negate`"),
            ("image: a.png\nresolution: 0.05\nresolution: 0.1\n", "line 3"),
            ("image: a.png\nresolution: 0.05\nfree_thresh: 0.9\n", "line 3: `free_thresh`"),
            ("image: a.png\nwhat is this\n", "line 2"),
            ("image: a.png\n  - 3\n", "line 1: `image` is \"a.png, 3\""),
            ("- 3\n", "line 1"),
            ("image: a.png\nresolutoin: 0.05\n", "did you mean"),
        ] {
            let error = read(text).unwrap_err();
            assert!(error.starts_with("hall.yaml") && error.contains(told), "{text:?}: {error}");
        }
    }
}
