//! Positions that others measured: `.pos`, NMEA, GPX and KML.

use schuler_simulator::recording::instant::Scale;
use schuler_simulator::recording::reference::Reference;
use schuler_simulator::reference::Track;

const POS: &str = "% program   : made here\n\
    %  GPST          latitude(deg) longitude(deg)  height(m)   Q  ns   sdn(m)   sde(m)   sdu(m)  sdne(m)  sdeu(m)  sdun(m) age(s)  ratio    vn(m/s)    ve(m/s)    vu(m/s)      sdvn     sdve     sdvu    sdvne    sdveu    sdvun\n";
const ROW: &str =
    "45.5 -100.25 300.125 1 20 0.01 0.02 0.03 0 0 0 0 5 1.5 -2.5 0.25 0.1 0.2 0.3 0 0 0";

#[track_caller]
fn parsed(file: &str, text: &str) -> Track {
    Track::parse(file, text).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn rtklib() {
    for (time, header) in [
        ("2024/08/25 00:00:01.250", "GPST"),
        ("2329 1.250", "GPST"),
        ("2024/08/24 23:59:43.250", "UTC "),
        ("2329 1.250", "UTC "),
    ] {
        let text = format!("{}{time} {ROW}\n", POS.replace("GPST", header));
        let track = parsed("a.pos", &text);
        let scale = if header == "GPST" { Scale::Gps } else { Scale::Utc };
        assert_eq!(track.scale, Some(scale));
        let track = track.on(Scale::Gps);
        let [fix] = track.fixes[..] else { panic!("{track:?}") };
        assert_eq!(fix.time_s, Some(2329.0 * 604_800.0 + 1.25), "{time} {header}");
        assert_eq!(fix.line, 3);
        assert_eq!((fix.latitude.to_degrees(), fix.longitude.to_degrees()), (45.5, -100.25));
        assert_eq!(fix.height, Some(300.125));
        assert_eq!(fix.north_east, Some([1.5, -2.5]));
        assert_eq!(fix.down, Some(-0.25));
        let sigma = |v: Option<schuler::math::vector::Vector<f64>>| v.map(|v| v.into_array());
        assert_eq!(sigma(fix.position_sigma_ned), Some([0.01, 0.02, 0.03]));
        assert_eq!(sigma(fix.velocity_sigma_ned), Some([0.1, 0.2, 0.3]));
    }
    // Without velocities, and with commas.
    let short = format!("{POS}2329,1.25,45.5,-100.25,300.125,1,20,0.01,0.02,0.03,0,0,0,0,5\n");
    assert_eq!(parsed("a.pos", &short).fixes[0].north_east, None);
}

#[test]
fn a_reference_is_told_on_the_recordings_scale() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("a.pos");
    std::fs::write(&path, format!("{POS}2329 1.25 {ROW}\n2329 1.5 {ROW}\n")).expect("room");
    let name = path.to_str().expect("a plain name");
    for (scale, first_s) in [
        (Some(Scale::Gps), 2329.0 * 604_800.0 + 1.25),
        (Some(Scale::Utc), 1_724_544_001.25 - 18.0),
        (None, 1_724_544_001.25 - 18.0),
    ] {
        let reference = Reference::open(name, scale).unwrap_or_else(|e| panic!("{e}"));
        let [(time_s, state), (later_s, _)] = reference.rows[..] else { panic!("{reference:?}") };
        assert_eq!((time_s, later_s), (first_s, first_s + 0.25));
        assert!(reference.has_velocity && !reference.has_attitude);
        assert_eq!(state.velocity_ned.z.hi, -0.25);
        assert!((state.position.latitude.hi.to_degrees() - 45.5).abs() < 1e-12);
    }
    std::fs::write(&path, format!("{POS}2329 1.5 {ROW}\n2329 1.5 {ROW}\n")).expect("room");
    let error = Reference::open(name, None).expect_err("twice at once").to_string();
    assert!(error.contains("a.pos:4: is not after"), "{error}");
}

#[test]
fn nmea() {
    let sum = |body: &str| {
        let sum = body.bytes().fold(0, |sum, byte| sum ^ byte);
        format!("${body}*{sum:02X}\r\n")
    };
    let gga = |clock: &str| {
        sum(&format!("GPGGA,{clock},4530.0000,N,10015.0000,W,4,12,0.8,320.125,M,-20.000,M,,"))
    };
    let rmc = |clock: &str, date: &str| {
        sum(&format!("GNRMC,{clock},A,4530.0000,N,10015.0000,W,10.0,090.0,{date},,,A"))
    };
    // Over midnight; the date comes with the second time alone.
    let mut text = gga("235959.50") + &sum("GPGSV,1,1,00");
    text += &(gga("000000.00") + &rmc("000000.00", "250824"));
    text += &gga("000000.50").replace("4530", "4531");
    text += &sum("GPGGA,000001.00,,,,,0,00,,,M,,M,,");
    let track = parsed("a.nmea", &text);
    assert_eq!(track.scale, Some(Scale::Utc));
    let midnight_s = 1_724_544_000.0;
    let times: Vec<_> = track.fixes.iter().map(|fix| fix.time_s).collect();
    assert_eq!(times, [Some(midnight_s - 0.5), Some(midnight_s)]);
    let fix = track.fixes[1];
    assert_eq!((fix.latitude.to_degrees(), fix.longitude.to_degrees()), (45.5, -100.25));
    assert_eq!(fix.height, Some(300.125));
    let [north, east] = fix.north_east.expect("RMC has it");
    assert!(north.abs() < 1e-12 && (east - 18520.0 / 3600.0).abs() < 1e-12, "{north} {east}");
    let said = track.said.join("\n");
    assert!(said.contains("damaged, left out: 1") && said.contains("a.nmea:5"), "{said}");
    assert!(said.contains("without a position, left out: 1"), "{said}");
    // Times of day alone have no scale.
    let track = parsed("a.nmea", &gga("120000.00"));
    assert_eq!((track.scale, track.fixes[0].time_s), (None, Some(43_200.0)));
}

#[test]
fn gpx() {
    let text = "<?xml version=\"1.0\"?>\n<gpx version=\"1.1\" creator=\"made here\" xmlns=\"http://www.topografix.com/GPX/1/1\">\
        <wpt lat=\"1\" lon=\"2\"></wpt>\
        <trk><trkseg><trkpt lat=\"45.5\" lon=\"-100.25\"><ele>320.125</ele><time>2024-08-25T00:00:00.5Z</time>\
        <geoidheight>-20</geoidheight></trkpt>\
        <trkpt lat=\"45.6\" lon=\"-100.25\"></trkpt></trkseg></trk></gpx>";
    let track = parsed("a.gpx", text);
    assert_eq!(track.fixes.len(), 2);
    let fix = track.fixes[0];
    assert_eq!((fix.latitude.to_degrees(), fix.longitude.to_degrees()), (45.5, -100.25));
    assert_eq!((fix.height, fix.time_s), (Some(300.125), Some(1_724_544_000.5)));
    assert_eq!((track.fixes[1].height, track.fixes[1].time_s), (None, None));
    assert!(track.said.is_empty(), "{:?}", track.said);
    let above = text.replace("<geoidheight>-20</geoidheight>", "");
    assert!(parsed("a.gpx", &above).said[0].contains("above the geoid"));
}

#[test]
fn kml() {
    let kml = |inside: &str| {
        format!(
            "<?xml version=\"1.0\"?><kml xmlns=\"http://www.opengis.net/kml/2.2\" \
             xmlns:gx=\"http://www.google.com/kml/ext/2.2\"><Document><Folder><Placemark>{inside}</Placemark></Folder></Document></kml>"
        )
    };
    let line = kml(
        "<LineString><altitudeMode>absolute</altitudeMode><coordinates>-100.25,45.5,300.125 -100,45.6,310</coordinates></LineString>",
    );
    let track = parsed("a.kml", &line);
    assert_eq!(track.fixes.len(), 2);
    assert_eq!(track.fixes[0].longitude.to_degrees(), -100.25);
    assert_eq!(track.fixes[1].height, Some(310.0));
    let ground = line.replace("<altitudeMode>absolute</altitudeMode>", "");
    let track = parsed("a.kml", &ground);
    assert!(track.fixes[0].height.is_none() && track.said[0].contains("the ground"), "{track:?}");
    let moving =
        kml("<gx:Track><altitudeMode>absolute</altitudeMode><when>2024-08-25T00:00:00Z</when>\
         <when>2024-08-25T00:00:01Z</when><gx:coord>-100.25 45.5 300</gx:coord>\
         <gx:coord>-100.25 45.6 301</gx:coord></gx:Track>");
    let track = parsed("a.kml", &moving);
    let times: Vec<_> = track.fixes.iter().map(|fix| fix.time_s).collect();
    assert_eq!(times, [Some(1_724_544_000.0), Some(1_724_544_001.0)]);
    assert_eq!(track.fixes[1].height, Some(301.0));
    assert_eq!(track.scale, Some(Scale::Utc));
}

#[test]
fn errors_name_file_line_and_column() {
    let good = format!("{POS}2329 1.25 {ROW}\n2329 1.5 {ROW}\n");
    for (from, to, start, words) in [
        ("1.5 45.5", "1.5 95.5", "a.pos:4: latitude: 95.5 is out of range", "-90 to 90"),
        ("1.5 45.5 -100.25", "1.5 45.5 x", "a.pos:4: longitude: \"x\"", "finite"),
        (
            "2329 1.5 45.5 -100.25 300.125 1 20 0.01 0.02 0.03 0 0 0 0 5 1.5 -2.5 0.25 0.1 0.2 0.3 0 0 0",
            "2329 1.5 45.5 -100.25",
            "a.pos:4: the row has 4 values",
            "10 or more: date, time, latitude",
        ),
        ("latitude(deg)", "x-ecef(m)", "a.pos:2: has positions or times in another form", "llh"),
    ] {
        let text = good.replacen(from, to, 1);
        let message = Track::parse("a.pos", &text).expect_err(start).to_string();
        assert!(message.starts_with(start) && message.contains(words), "{message}\nnot {start}");
    }
    for (text, start) in [
        ("", "a: is none of the files of positions"),
        ("hello", "a: is none of the files of positions"),
        (POS, "a: has no position"),
        ("<gpx", "a: is no GPX"),
        ("<kml><Placemark>", "a: is no KML"),
    ] {
        let message = Track::parse("a", text).expect_err(start).to_string();
        assert!(message.starts_with(start), "{message}\nnot {start}");
    }
}
