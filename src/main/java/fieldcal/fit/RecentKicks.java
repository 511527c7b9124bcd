package fieldcal.fit;

import fieldcal.fit.OverlapOffsets.Pair;
import fieldcal.kick.Kick;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;

/**
 * What the last kicks of a match determine about the cameras: lenses that cannot be used, noise, and offsets. What one kick contributes does not depend on the others, so it is computed once; the result is that of {@link LensCheck#usable}, {@link CameraNoise#measured} and {@link OverlapOffsets#estimate} for these
 * kicks. Mutable, for one thread.
 */
public final class RecentKicks {
  private final CameraViews published;
  private final int memory;
  private final Deque<Evidence> kicks = new ArrayDeque<>();

  /** What one kick contributes. */
  private final class Evidence {
    private final Kick kick;
    private final int[] cameras;
    private final LensCounts lenses;
    private final Map<Integer, CameraNoise.Grid> grids;
    private final Map<Pair, SharedView> shared;
    private Set<Integer> without = Set.of();
    private Map<Integer, double[]> squares;

    Evidence(Kick kick) {
      this.kick = kick;
      cameras = kick.observations().cameras();
      lenses = LensCheck.count(kick, published);
      grids = CameraNoise.grids(kick);
      shared = OverlapOffsets.compare(kick, published);
    }

    /** Deviations of the resting ball, which the lenses scale. */
    Map<Integer, double[]> squares(Set<Integer> unusable, CameraViews views) {
      if (squares == null || !unusable.equals(without)) {
        without = unusable;
        squares = CameraNoise.squaresAtRest(kick, views);
      }
      return squares;
    }
  }

  /**
   * Starts without kicks.
   *
   * @param published the cameras as published, without offsets
   * @param memory how many kicks count, at least 1: when there are more, the oldest are forgotten
   * @throws IllegalArgumentException when the memory is too small
   */
  public RecentKicks(CameraViews published, int memory) {
    if (memory < 1) {
      throw new IllegalArgumentException("memory must be at least 1, but is " + memory);
    }
    this.published = published;
    this.memory = memory;
  }

  /**
   * Adds a kick.
   *
   * @param kick of any kind
   */
  public void add(Kick kick) {
    kicks.add(new Evidence(kick));
    if (kicks.size() > memory) {
      kicks.remove();
    }
  }

  /**
   * The cameras that are published or that saw one of the kicks.
   *
   * @param before views whose noise is kept for a camera that saw too few resting detections
   * @return the views with noise and offsets; without unusable lenses
   */
  public CameraViews views(CameraViews before) {
    Set<Integer> unusable = LensCheck.unusable(all(e -> e.lenses)).keySet();
    CameraViews known =
        LensCheck.without(unusable, withUnpublished())
            .map(v -> v.withNoise(before.get(v.id()).noise()));
    CameraViews measured =
        CameraNoise.measured(all(e -> e.grids), all(e -> e.squares(unusable, known)), known);
    return OverlapOffsets.estimateFrom(all(e -> e.shared), measured);
  }

  private <T> List<T> all(Function<Evidence, T> part) {
    return kicks.stream().map(part).toList();
  }

  private CameraViews withUnpublished() {
    Set<Integer> ids = new TreeSet<>();
    for (Evidence e : kicks) {
      for (int id : e.cameras) {
        ids.add(id);
      }
    }
    List<CameraView> all = new ArrayList<>(published.all());
    all.forEach(v -> ids.remove(v.id()));
    ids.forEach(id -> all.add(CameraView.of(id, Optional.empty())));
    return CameraViews.of(all);
  }
}
