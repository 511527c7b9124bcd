package fieldcal.app.cli;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.camera.CameraCalibration;
import fieldcal.gamelog.CameraStatistics;
import fieldcal.gamelog.ProblemAccount;
import fieldcal.gamelog.RecordingSummary;
import fieldcal.gamelog.RefereeStatistics;
import fieldcal.gamelog.TrackerStatistics;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.ProblemKind;
import java.util.List;
import java.util.Locale;

/** {@link RecordingInfo} for programs: schema {@code fieldcal.info/1}. Unknown numbers are null. */
final class InfoJson {
  private final ObjectMapper mapper = new ObjectMapper();

  String of(RecordingInfo info) throws JsonProcessingException {
    RecordingSummary summary = info.summary();
    ObjectNode root = mapper.createObjectNode();
    root.put("schema", "fieldcal.info/1");
    root.put("source", info.file().toString());
    root.put("simulated", info.simulated());
    root.put("file_bytes", summary.fileBytes());
    root.put("log_bytes", summary.logBytes());
    put(root, "start_unix", summary.epoch().unixSeconds(summary.firstTime()));
    put(root, "duration_s", summary.duration());
    ObjectNode messages = root.putObject("messages");
    summary.messages().forEach((type, count) -> messages.put(lower(type), count));
    root.put("frames", summary.frames());
    addCameras(root.putArray("cameras"), info.cameras());
    summary
        .geometry()
        .ifPresentOrElse(
            geometry -> addGeometry(root.putObject("geometry"), info, geometry),
            () -> root.putNull("geometry"));
    info.referee()
        .ifPresentOrElse(
            referee -> addReferee(root.putObject("referee"), referee, summary),
            () -> root.putNull("referee"));
    addTrackers(root.putArray("trackers"), info.trackers());
    addProblems(root.putArray("problems"), summary.problems());
    return mapper.writerWithDefaultPrettyPrinter().writeValueAsString(root);
  }

  private static void addCameras(ArrayNode array, List<CameraStatistics> cameras) {
    for (CameraStatistics camera : cameras) {
      ObjectNode node = array.addObject();
      node.put("id", camera.id());
      node.put("frames", camera.frames());
      put(node, "rate_hz", camera.rate());
      node.put("lost_frames", camera.lostFrames());
      node.put("gaps", camera.gaps());
      put(node, "longest_gap_s", camera.longestGap());
      put(node, "jitter_ms", 1e3 * camera.jitter());
      put(node, "latency_ms", 1e3 * camera.latency());
      put(node, "clock_difference_s", camera.clockDifference());
      put(node, "clock_rate", camera.clockRate());
      node.put("balls", camera.ballDetections());
      node.put("robots", camera.robotDetections());
      put(node, "noise_mm", 1e3 * camera.ballNoise());
      node.put("resting_stretches", camera.restingBlocks());
    }
  }

  private static void addTrackers(ArrayNode array, List<TrackerStatistics> trackers) {
    for (TrackerStatistics tracker : trackers) {
      ObjectNode node = array.addObject();
      node.put("source", tracker.source());
      node.put("uuid", tracker.uuid());
      node.put("frames", tracker.frames());
      put(node, "rate_hz", tracker.rate());
      put(node, "delay_ms", 1e3 * tracker.delay());
      put(node, "ball_share", tracker.ballShare());
      node.put("kicks", tracker.kicks());
    }
  }

  private static void addGeometry(ObjectNode node, RecordingInfo info, FieldGeometry geometry) {
    node.put("length_m", geometry.length());
    node.put("width_m", geometry.width());
    node.put("goal_width_m", geometry.goalWidth());
    node.put("goal_depth_m", geometry.goalDepth());
    node.put("boundary_width_m", geometry.boundaryWidth());
    ArrayNode cameras = node.putArray("cameras");
    for (CameraCalibration calibration : geometry.cameras()) {
      ObjectNode camera = cameras.addObject();
      camera.put("id", calibration.id());
      camera.put("note", info.note(calibration));
    }
    ObjectNode models = node.putObject("models");
    geometry
        .flat()
        .ifPresent(
            flat ->
                models
                    .putObject("flat")
                    .put("acc_slide", flat.accSlide())
                    .put("acc_roll", flat.accRoll())
                    .put("k_switch", flat.kSwitch()));
    geometry
        .chip()
        .ifPresent(
            chip ->
                models
                    .putObject("chip")
                    .put("damping_xy_first_hop", chip.dampingXyFirstHop())
                    .put("damping_xy_other_hops", chip.dampingXyOtherHops())
                    .put("damping_z", chip.dampingZ()));
  }

  private static void addReferee(
      ObjectNode node, RefereeStatistics referee, RecordingSummary summary) {
    node.put("messages", referee.messages());
    node.put("yellow", referee.last().yellow().name());
    node.put("blue", referee.last().blue().name());
    node.putArray("score").add(referee.last().yellow().score()).add(referee.last().blue().score());
    ArrayNode stages = node.putArray("stages");
    referee
        .stages()
        .forEach(
            start ->
                stages
                    .addObject()
                    .put("t_s", start.time() - summary.firstTime())
                    .put("stage", lower(start.stage())));
    ObjectNode commands = node.putObject("commands");
    referee.commands().forEach((command, count) -> commands.put(lower(command), count));
  }

  private static void addProblems(ArrayNode array, ProblemAccount problems) {
    for (ProblemKind kind : problems.kinds()) {
      ObjectNode node = array.addObject();
      node.put("kind", kind.id());
      node.put("count", problems.count(kind));
      node.put("text", kind.text());
      ArrayNode first = node.putArray("first");
      problems
          .first(kind)
          .forEach(
              occurrence ->
                  first
                      .addObject()
                      .put("offset", occurrence.offset())
                      .put("detail", occurrence.detail()));
    }
  }

  private static void put(ObjectNode node, String name, double value) {
    if (Double.isFinite(value)) {
      node.put(name, value);
    } else {
      node.putNull(name);
    }
  }

  private static String lower(Enum<?> value) {
    return value.name().toLowerCase(Locale.ROOT);
  }
}
