package fieldcal.app.export.format;

import fieldcal.app.calibrate.InputException;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.codehaus.stax2.XMLStreamReader2;

/**
 * XML with one element per value, as {@code com.github.g3force:configurable} writes it for TIGERs' Sumatra: the root's attribute {@code base} is the beginning of the class names, and the elements are the rest of the class
 * name, then the field, after which {@code :ENVIRONMENT} may stand.
 */
final class ElementsForm implements ConfigForm {

  @Override
  public String title() {
    return "XML";
  }

  @Override
  public List<Leaf> leaves(BaseFile base) throws InputException {
    XmlReader xml = new XmlReader(base, XMLStreamReader2::getLocalName);
    List<Leaf> found = xml.leaves();
    Matcher root =
        Pattern.compile("<" + Pattern.quote(xml.root()) + "\\b[^>]*\\bbase=\"([^\"]*)\"")
            .matcher(base.text());
    String prefix = root.find() ? root.group(1) + "." : "";
    return found.stream().map(leaf -> ofClass(prefix, leaf)).toList();
  }

  /** Class and field, however much of the class name the root has. */
  private static Leaf ofClass(String prefix, Leaf leaf) {
    String whole = prefix + String.join(".", leaf.path());
    int dot = whole.lastIndexOf('.');
    return dot < 0
        ? leaf
        : new Leaf(
            List.of(whole.substring(0, dot), whole.substring(dot + 1)), leaf.start(), leaf.end());
  }

  @Override
  public String render(List<Setting> settings, List<String> comments) {
    Map<String, Object> classes = ConfigForm.tree(settings);
    if (classes.size() != 1) {
      throw new IllegalArgumentException("one class at a time, not " + classes.keySet());
    }
    Map.Entry<String, Object> only = classes.entrySet().iterator().next();
    StringBuilder text = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    text.append(XmlComments.of(comments));
    text.append("<configuration base=\"").append(only.getKey()).append("\">\n");
    ((Map<?, ?>) only.getValue())
        .forEach(
            (field, value) -> {
              text.append("  <").append(field).append('>').append(((Setting) value).text());
              text.append("</").append(field).append(">\n");
            });
    return text.append("</configuration>\n").toString();
  }
}
