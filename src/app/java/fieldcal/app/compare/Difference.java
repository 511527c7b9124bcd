package fieldcal.app.compare;

import fieldcal.effect.ExtendedModel;
import java.util.function.UnaryOperator;

/**
 * Something of the ball that the simulator has otherwise than the field.
 *
 * @param id for files: a parameter's name or an effect's id; where another number of the effect than its magnitude differs, that number's name behind a dot
 * @param words what it is, as a part of a sentence
 * @param real the field's value; NaN when the field does not have it
 * @param realError its standard error; NaN when not known
 * @param sim the simulator's value; NaN when the simulator does not have it
 * @param simError its standard error; NaN when not known
 * @param unit of the values
 * @param asSimulated gives a model of the field the simulator's value
 */
record Difference(
    String id,
    String words,
    double real,
    double realError,
    double sim,
    double simError,
    String unit,
    UnaryOperator<ExtendedModel> asSimulated) {}
