package mmneat.contest.entry;

import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/** Replaces calls that end the program with those of {@link ControllerExit} in the byte code of an entry's class. */
final class ExitCalls extends ClassVisitor {

    private static final String SYSTEM = "java/lang/System";
    private static final String RUNTIME = "java/lang/Runtime";
    private static final Set<String> NAMES = Set.of("exit", "halt");
    private static final String STATUS = "(I)V";

    private boolean found;

    ExitCalls(@Nullable ClassVisitor next) {
        super(Opcodes.ASM9, next);
    }

    /** Whether a class calls a method that ends the program. */
    static boolean areIn(ClassReader type) {
        ExitCalls calls = new ExitCalls(null);
        type.accept(calls, ClassReader.SKIP_DEBUG | ClassReader.SKIP_FRAMES);
        return calls.found;
    }

    @Override
    public MethodVisitor visitMethod(
            int access, String name, String descriptor, String signature, String[] exceptions) {
        return new MethodVisitor(api, super.visitMethod(access, name, descriptor, signature, exceptions)) {
            @Override
            public void visitMethodInsn(
                    int opcode, String owner, String method, String arguments, boolean isInterface) {
                boolean ends = (owner.equals(SYSTEM) || owner.equals(RUNTIME))
                        && NAMES.contains(method)
                        && arguments.equals(STATUS);
                if (!ends) {
                    super.visitMethodInsn(opcode, owner, method, arguments, isInterface);
                    return;
                }
                found = true;
                String ours = opcode == Opcodes.INVOKESTATIC ? STATUS : "(L" + RUNTIME + ";I)V";
                super.visitMethodInsn(
                        Opcodes.INVOKESTATIC, Type.getInternalName(ControllerExit.class), method, ours, false);
            }
        };
    }
}
