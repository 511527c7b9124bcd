package fieldcal.fit;

import java.util.Collection;
import java.util.Collections;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.UnaryOperator;

/** The cameras of a recording by id; immutable. */
public final class CameraViews {
  private final Map<Integer, CameraView> views;

  private CameraViews(Map<Integer, CameraView> views) {
    this.views = Collections.unmodifiableMap(views);
  }

  /**
   * These cameras.
   *
   * @param views one each, in any order; of two with one id the later one counts
   * @return the collection, a copy
   */
  public static CameraViews of(Collection<CameraView> views) {
    Map<Integer, CameraView> byId = new TreeMap<>();
    views.forEach(v -> byId.put(v.id(), v));
    return new CameraViews(byId);
  }

  /**
   * One camera.
   *
   * @param id camera id
   * @return the view; of an unknown camera one without geometry and offset: its balls are taken to lie on the carpet where they are reported
   */
  public CameraView get(int id) {
    CameraView view = views.get(id);
    return view != null ? view : CameraView.of(id, Optional.empty());
  }

  /**
   * All cameras in the order of their ids.
   *
   * @return unmodifiable
   */
  public Collection<CameraView> all() {
    return views.values();
  }

  /**
   * Every camera changed in the same way.
   *
   * @param change applied to each
   * @return the changed copy
   */
  public CameraViews map(UnaryOperator<CameraView> change) {
    return of(views.values().stream().map(change).toList());
  }
}
