package fieldcal.diagnosis.hidden;

import fieldcal.camera.Camera;
import fieldcal.kick.Kick;
import fieldcal.kick.KickFinder;
import fieldcal.kick.KickFinderSettings;
import fieldcal.simulation.Simulation;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.truth.Truth;
import fieldcal.vision.FieldGeometry;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * The kicks that are found in a simulated recording; the recording itself is not kept.
 *
 * @param kicks numbered from 1
 * @param geometry as published
 * @param cameras as published, by id
 * @param firstFrame stamp of the first frame, s
 * @param truth what really happened
 */
record SeenKicks(
    List<Kick> kicks,
    FieldGeometry geometry,
    Map<Integer, Camera> cameras,
    double firstFrame,
    Truth truth) {

  static SeenKicks of(SimulationSettings settings) {
    Simulation simulation = Simulation.of(settings);
    FieldGeometry geometry = simulation.geometry();
    Map<Integer, Camera> cameras =
        geometry.cameras().stream().map(Camera::of).collect(Collectors.toMap(Camera::id, c -> c));
    List<Kick> kicks = new ArrayList<>();
    KickFinder finder =
        new KickFinder(
            KickFinderSettings.defaults(), kick -> kicks.add(kick.withId(kicks.size() + 1)));
    finder.geometry(geometry, cameras);
    double[] first = {Double.NaN};
    Truth truth =
        simulation.run(
            packet ->
                packet
                    .packet()
                    .frame()
                    .ifPresent(
                        frame -> {
                          if (Double.isNaN(first[0])) {
                            first[0] = frame.captureTime();
                          }
                          finder.accept(frame);
                        }));
    finder.finish();
    return new SeenKicks(kicks, geometry, cameras, first[0], truth);
  }
}
