package pacman;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.Type;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import mmneat.GoldenData;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.Opcodes;
import pacman.ProgrammingInterface.ClassBlock;
import pacman.ProgrammingInterface.Member;

/** The simulator has the programming interface of the competition: entries compile and link against it. */
class CompetitionApiTest {

    @TestFactory
    Stream<DynamicTest> ourManifest_isKept() throws IOException {
        return tests(ours());
    }

    @Tag("conformance")
    @TestFactory
    Stream<DynamicTest> competitionsInterface_isKept() throws IOException {
        try (BufferedReader text =
                Files.newBufferedReader(GoldenData.folder("api").resolve("competition-api.txt"))) {
            return tests(ProgrammingInterface.read(text));
        }
    }

    @Tag("conformance")
    @Test
    void ourManifest_listsAllOfTheCompetitionsInterface() throws IOException {
        Map<String, ClassBlock> listed = new HashMap<>();
        ours().classes().forEach(block -> listed.put(block.name(), block));
        try (BufferedReader text =
                Files.newBufferedReader(GoldenData.folder("api").resolve("competition-api.txt"))) {
            List<ClassBlock> expected = ProgrammingInterface.read(text).classes();
            assertThat(expected).hasSizeGreaterThan(30);
            for (ClassBlock block : expected) {
                assertThat(listed).containsKey(block.name());
                assertThat(listed.get(block.name()).members()).containsAll(block.members());
            }
        }
    }

    private static ProgrammingInterface ours() throws IOException {
        try (BufferedReader text = new BufferedReader(new InputStreamReader(
                CompetitionApiTest.class.getResourceAsStream("programming-interface.txt"), StandardCharsets.UTF_8))) {
            return ProgrammingInterface.read(text);
        }
    }

    private static Stream<DynamicTest> tests(ProgrammingInterface listed) {
        return listed.classes().stream().map(block -> DynamicTest.dynamicTest(block.name(), () -> check(block)));
    }

    private static void check(ClassBlock block) throws ClassNotFoundException, IOException {
        Class<?> type = Class.forName(block.name());
        List<String> faults = new ArrayList<>(classFaults(block, type));
        Map<String, Object> constants = constants(type);
        for (Member member : block.members()) {
            if (member.isField()) {
                faults.addAll(fieldFaults(member, type, constants));
            } else {
                faults.addAll(callFaults(member, block, type));
            }
        }
        assertThat(faults).isEmpty();
    }

    private static List<String> classFaults(ClassBlock block, Class<?> type) throws ClassNotFoundException {
        List<String> faults = new ArrayList<>();
        int modifiers = type.getModifiers();
        if (!Modifier.isPublic(modifiers)) {
            faults.add("the class is not public");
        }
        if (Modifier.isFinal(modifiers) && !block.modifiers().contains("final") && !type.isEnum()) {
            faults.add("the class must not be final");
        }
        if (Modifier.isAbstract(modifiers) && !block.modifiers().contains("abstract")) {
            faults.add("the class must not be abstract");
        }
        if (block.superclass() != null && !Class.forName(block.superclass()).isAssignableFrom(type)) {
            faults.add("the class does not extend " + block.superclass());
        }
        return faults;
    }

    private static List<String> fieldFaults(Member member, Class<?> type, Map<String, Object> constants) {
        Field field;
        try {
            field = type.getDeclaredField(member.name());
        } catch (NoSuchFieldException e) {
            return List.of("missing field " + member.name());
        }
        List<String> faults = new ArrayList<>(modifierFaults(member, field.getModifiers()));
        if (!simplified(field.getGenericType()).equals(simplified(member.type()))) {
            faults.add(member.name() + " is a " + field.getGenericType().getTypeName() + ", not a " + member.type());
        }
        if (Modifier.isFinal(field.getModifiers()) && !member.modifiers().contains("final")) {
            faults.add(member.name() + " must not be final");
        }
        // The paths of the competition's data files may differ.
        boolean path = member.name().startsWith("path");
        Object constant = constants.get(member.name());
        if (member.value() != null
                && (constant == null || !path && !literal(constant).equals(member.value()))) {
            faults.add(member.name() + " must be the compile-time constant " + member.value() + ", is " + constant);
        }
        return faults;
    }

    private static String literal(Object constant) {
        if (constant instanceof String) {
            return '"' + constant.toString() + '"';
        }
        return constant instanceof Float ? constant + "f" : constant.toString();
    }

    private static List<String> callFaults(Member member, ClassBlock block, Class<?> type) {
        boolean constructor = member.name().equals(block.name());
        Executable call = Stream.<Executable>concat(
                        constructor ? Arrays.stream(type.getDeclaredConstructors()) : Stream.empty(),
                        constructor ? Stream.empty() : methods(type))
                .filter(candidate -> constructor || candidate.getName().equals(member.name()))
                .filter(candidate -> parameters(candidate).equals(wanted(member, candidate)))
                .filter(candidate -> !(candidate instanceof Method method) || !method.isBridge())
                .findFirst()
                .orElse(null);
        if (call == null) {
            return List.of("missing " + member);
        }
        List<String> faults = new ArrayList<>(modifierFaults(member, call.getModifiers()));
        if (call instanceof Method method
                && !simplified(method.getGenericReturnType()).equals(simplified(member.type()))) {
            faults.add(member.name() + " answers with " + method.getGenericReturnType() + ", not " + member.type());
        }
        boolean controllersFinalMethod = block.name().equals("pacman.controllers.Controller")
                && member.modifiers().contains("final");
        if (controllersFinalMethod && !Modifier.isFinal(call.getModifiers())) {
            faults.add(member.name() + " must be final");
        }
        if (!constructor
                && Modifier.isFinal(call.getModifiers())
                && !member.modifiers().contains("final")
                && !Modifier.isFinal(type.getModifiers())) {
            faults.add(member.name() + " must not be final");
        }
        return faults;
    }

    /** Returns declared and inherited methods, the most specific first. */
    private static Stream<Method> methods(Class<?> type) {
        return Stream.<Class<?>>iterate(type, java.util.Objects::nonNull, Class::getSuperclass)
                .flatMap(declaring -> Arrays.stream(declaring.getDeclaredMethods()));
    }

    /** Constructors of inner classes have a hidden parameter that only their erased types show. */
    private static List<String> parameters(Executable call) {
        Type[] types = call instanceof Constructor<?> ? call.getParameterTypes() : call.getGenericParameterTypes();
        return Arrays.stream(types).map(CompetitionApiTest::simplified).toList();
    }

    private static List<String> wanted(Member member, Executable call) {
        return member.parameters().stream()
                .map(type -> type.replace("...", "[]"))
                .map(type -> call instanceof Constructor<?> ? type.replaceAll("<.*>", "") : type)
                .map(CompetitionApiTest::simplified)
                .toList();
    }

    private static List<String> modifierFaults(Member member, int modifiers) {
        List<String> faults = new ArrayList<>();
        boolean visible = Modifier.isPublic(modifiers)
                || member.modifiers().contains("protected") && Modifier.isProtected(modifiers);
        if (!visible) {
            faults.add(member.name() + " is not visible");
        }
        if (Modifier.isStatic(modifiers) != member.modifiers().contains("static")) {
            faults.add(member.name() + " must " + (Modifier.isStatic(modifiers) ? "not " : "") + "be static");
        }
        if (Modifier.isAbstract(modifiers) && !member.modifiers().contains("abstract")) {
            faults.add(member.name() + " must not be abstract");
        }
        return faults;
    }

    private static String simplified(Type type) {
        return simplified(type.getTypeName());
    }

    private static String simplified(String type) {
        return type.replace(" ", "");
    }

    /** Returns the constants, whose values the compiler copies into the code that uses them. */
    private static Map<String, Object> constants(Class<?> type) throws IOException {
        Map<String, Object> constants = new HashMap<>();
        String file = type.getName().substring(type.getName().lastIndexOf('.') + 1) + ".class";
        new ClassReader(type.getResourceAsStream(file).readAllBytes())
                .accept(
                        new ClassVisitor(Opcodes.ASM9) {
                            @Override
                            public FieldVisitor visitField(
                                    int access, String name, String descriptor, String signature, Object value) {
                                if (value != null) {
                                    constants.put(name, value);
                                }
                                return null;
                            }
                        },
                        0);
        return constants;
    }
}
