// How faces take the light. It is added up at the corners and shown as it comes out: on a processor that draws, what is worked out at every
// point of the picture is what costs.

import { Color, DoubleSide, FrontSide, LineBasicMaterial, ShaderMaterial } from "three";

/** From where the sun shines; how bright sun, sky, and what the ground gives back are. */
const LIGHT = `
const vec3 SUN = vec3(-0.337, -0.449, 0.842);
const vec3 SKY = vec3(1.85);
vec3 lit(vec3 base, vec3 normal, vec3 ground) {
  float sun = 1.9 * max(0.0, dot(normal, SUN));
  return base * (sun + mix(ground, SKY, 0.5 + 0.5 * normal.z)) / 3.14159;
}`;

const LIT_VERTEX = `
uniform vec3 tint;
uniform vec3 ground;
varying vec3 shade;
${LIGHT}
void main() {
  vec4 place = vec4(position, 1.0);
  vec3 side = normal;
  #ifdef USE_INSTANCING
    place = instanceMatrix * place;
    side = mat3(instanceMatrix) * side;
  #endif
  side = normalize(mat3(modelMatrix) * side);
  #ifdef BOTH_SIDES
    vec4 seen = modelMatrix * place;
    side *= dot(side, cameraPosition - seen.xyz) < 0.0 ? -1.0 : 1.0;
  #endif
  vec3 base = tint;
  #ifdef USE_COLOR
    base *= pow(color, vec3(2.2));
  #endif
  shade = pow(lit(base, side, ground), vec3(1.0 / 2.2));
  gl_Position = projectionMatrix * modelViewMatrix * place;
}`;

const LIT_FRAGMENT = `
uniform float opacity;
varying vec3 shade;
void main() { gl_FragColor = vec4(shade, opacity); }`;

const FLAT_VERTEX = `void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`;
const FLAT_FRAGMENT = `
uniform vec3 colour;
uniform float opacity;
void main() { gl_FragColor = vec4(colour, opacity); }`;

/** A face that sun and sky light. Options: vertexColors (as they are shown), opacity (below 1 it is seen through), bothSides. */
export function litMaterial(theme, colour, { vertexColors = false, opacity = 1, bothSides = false } = {}) {
  return new ShaderMaterial({
    vertexShader: LIT_VERTEX, fragmentShader: LIT_FRAGMENT, vertexColors, transparent: opacity < 1, depthWrite: opacity === 1, side: bothSides ? DoubleSide : FrontSide, forceSinglePass: true,
    defines: bothSides ? { BOTH_SIDES: "" } : {},
    uniforms: { tint: { value: new Color(colour) }, ground: { value: new Color(theme.dark ? 0x555c66 : 0xb9b2a6).multiplyScalar(1.5).addScalar(0.35) }, opacity: { value: opacity } },
  });
}

/** One colour, as it is. */
export function flatMaterial(colour, opacity = 1) {
  const { r, g, b } = new Color(colour).convertLinearToSRGB();
  return new ShaderMaterial({ vertexShader: FLAT_VERTEX, fragmentShader: FLAT_FRAGMENT, transparent: opacity < 1, depthWrite: opacity === 1, uniforms: { colour: { value: [r, g, b] }, opacity: { value: opacity } } });
}

export function makeMaterials(theme) {
  const lit = (colour, more) => litMaterial(theme, colour, more);
  return {
    // Seen through, so that what happens below a pad shows.
    pad: lit(theme.dark ? 0x6f9cc0 : 0x6d93b5, { opacity: 0.45 }),
    face: lit(theme.dark ? 0x6f9cc0 : 0x6d93b5, { opacity: 0.45, bothSides: true }),
    plate: lit(theme.dark ? 0x8a929b : 0x9aa0a8, { opacity: 0.4 }),
    finger: lit(theme.dark ? 0x6b7077 : 0x9aa0a8),
    palm: lit(theme.dark ? 0x565b62 : 0x858b93),
    floor: flatMaterial(theme.dark ? 0x1f2429 : 0xece9e3),
    grid: new LineBasicMaterial({ color: theme.dark ? 0x343b42 : 0xd5d0c7 }),
    listed: lit(theme.dark ? 0x4a4f55 : 0xcfc9bd, { opacity: 0.75, bothSides: true }),
    ghost: lit(theme.dark ? 0x9fd0ee : 0x4a7fb0, { opacity: 0.16 }),
    line: new LineBasicMaterial({ color: theme.dark ? 0xa0a7af : 0x626972 }),
  };
}
