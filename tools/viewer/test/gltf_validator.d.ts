// Types for the parts of the Khronos validator's answer that the tests use; the package has no types.
declare module "gltf-validator" {
  export function validateBytes(bytes: Uint8Array): Promise<{
    issues: { messages: { code: string; message: string; pointer?: string; severity: number }[] };
    info: { animationCount: number; hasMorphTargets: boolean };
  }>;
}
