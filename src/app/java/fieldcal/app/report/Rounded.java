package fieldcal.app.report;

import com.fasterxml.jackson.annotation.JacksonAnnotationsInside;
import com.fasterxml.jackson.databind.annotation.JsonSerialize;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** A {@code double} or {@code double[]} written to JSON with a fixed number of decimals at most; not finite becomes null. */
@Retention(RetentionPolicy.RUNTIME)
@Target({ElementType.FIELD, ElementType.METHOD})
@JacksonAnnotationsInside
@JsonSerialize(using = RoundingSerializer.class)
public @interface Rounded {
  /**
   * Decimals kept.
   *
   * @return 0 or more
   */
  int value();
}
