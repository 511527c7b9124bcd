package fieldcal.app.export.format;

import fieldcal.app.calibrate.InputException;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * XML as VarTypes writes it, the library of settings of SSL-Vision and grSim: {@code <Var name="…" type="double" minval="…" maxval="…">0.7</Var>} in lists of the same element
 * (RoboCup-SSL/ssl-vision, {@code src/shared/vartypes}).
 */
final class VarTypesForm implements ConfigForm {

  @Override
  public String title() {
    return "VarTypes XML";
  }

  @Override
  public List<Leaf> leaves(BaseFile base) throws InputException {
    XmlReader xml =
        new XmlReader(
            base,
            reader ->
                reader.getLocalName().equals("Var")
                    ? reader.getAttributeValue(null, "name")
                    : null);
    List<Leaf> leaves = xml.leaves();
    if (!xml.root().equals("VarXML")) {
      throw new InputException(
          base.name() + ": is not VarTypes XML: its root is <" + xml.root() + ">, not <VarXML>");
    }
    return leaves;
  }

  @Override
  public String render(List<Setting> settings, List<String> comments) {
    StringBuilder text = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    text.append(XmlComments.of(comments)).append("<VarXML>\n");
    append(text, ConfigForm.tree(settings), "  ");
    return text.append("</VarXML>\n").toString();
  }

  private static void append(StringBuilder text, Map<?, ?> tree, String indent) {
    tree.forEach(
        (name, value) -> {
          text.append(indent).append("<Var name=\"").append(name).append("\" type=\"");
          if (value instanceof Setting s) {
            // Without bounds VarTypes would take away those that the program has.
            text.append("double\" minval=\"").append(bound(s.min()));
            text.append("\" maxval=\"").append(bound(s.max())).append("\">");
            text.append(s.text()).append("</Var>\n");
          } else {
            text.append("list\">\n");
            append(text, (Map<?, ?>) value, indent + "  ");
            text.append(indent).append("</Var>\n");
          }
        });
  }

  private static String bound(double value) {
    return Double.isFinite(value) ? String.format(Locale.ROOT, "%.6f", value) : "";
  }
}
