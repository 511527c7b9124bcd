package fieldcal.testing;

import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.effect.ObservedCamera;
import fieldcal.fit.CameraView;
import fieldcal.fit.CameraViews;
import fieldcal.fit.LensCheck;
import fieldcal.gamelog.RecordingListener;
import fieldcal.gamelog.RecordingReader;
import fieldcal.kick.Kick;
import fieldcal.kick.KickFinder;
import fieldcal.kick.KickFinderSettings;
import fieldcal.vision.BallModels;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionFrame;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * The kicks of one recording and the cameras that saw them, with the first geometry of the recording.
 *
 * @param kicks in order of time
 * @param cameras as published; without the lens where the published one does not fit the kicks
 * @param observers what is published of the cameras, for the effects
 * @param published models of the ball
 * @param epoch of the kicks' times
 * @param sessionStart time of the first frame, s since the epoch
 */
record ReadKicks(
    List<Kick> kicks,
    CameraViews cameras,
    List<ObservedCamera> observers,
    BallModels published,
    Epoch epoch,
    double sessionStart) {

  static ReadKicks of(Path recording) throws IOException {
    try (RecordingReader reader = RecordingReader.open(recording)) {
      Listener listener = new Listener();
      reader.read(listener);
      listener.finder.finish();
      List<CameraView> views = new ArrayList<>();
      listener.seen.forEach(
          (id, unused) ->
              views.add(CameraView.of(id, Optional.ofNullable(listener.cameras.get(id)))));
      CameraViews usable = LensCheck.usable(listener.kicks, CameraViews.of(views));
      return new ReadKicks(
          List.copyOf(listener.kicks),
          usable,
          listener.observers(usable),
          listener.published(),
          reader.epoch(),
          Double.isNaN(listener.start) ? 0 : listener.start);
    }
  }

  private static final class Listener implements RecordingListener {
    private final List<Kick> kicks = new ArrayList<>();
    private final KickFinder finder = new KickFinder(KickFinderSettings.defaults(), kicks::add);
    private final Map<Integer, Camera> cameras = new TreeMap<>();
    private final Map<Integer, CameraCalibration> calibrations = new TreeMap<>();
    private final Map<Integer, Boolean> seen = new TreeMap<>();
    private FieldGeometry field;
    private double start = Double.NaN;

    @Override
    public void onGeometry(FieldGeometry geometry) {
      if (field == null || geometry.completes(field)) {
        field = geometry;
      }
      for (CameraCalibration calibration : geometry.cameras()) {
        if (calibrations.putIfAbsent(calibration.id(), calibration) == null) {
          try {
            cameras.put(calibration.id(), Camera.of(calibration));
          } catch (IllegalArgumentException unusable) {
            // The camera is used as one without a calibration.
          }
        }
      }
      finder.geometry(geometry, cameras);
    }

    @Override
    public void onFrame(VisionFrame frame, double receivedTime) {
      if (Double.isNaN(start)) {
        start = frame.captureTime();
      }
      seen.put(frame.cameraId(), true);
      finder.accept(frame);
    }

    private BallModels published() {
      return field == null ? BallModels.NONE : new BallModels(field.flat(), field.chip());
    }

    private List<ObservedCamera> observers(CameraViews usable) {
      List<ObservedCamera> all = new ArrayList<>();
      for (CameraView view : usable.all()) {
        all.add(
            view.camera()
                .filter(c -> calibrations.containsKey(view.id()))
                .map(c -> ObservedCamera.of(calibrations.get(view.id()), c, seen.size()))
                .orElseGet(() -> ObservedCamera.unknown(view.id(), seen.size())));
      }
      return all;
    }
  }
}
