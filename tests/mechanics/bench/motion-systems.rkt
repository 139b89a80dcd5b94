#lang racket/base
;; The motions that are measured: systems, where they start, and the same formulas in C.

(require mechanics
         "systems.rkt")

(provide
 driven-pendulum driven-parameters
 rigid-body rigid-body-start three-bodies three-bodies-start
 Henon-Heiles Henon-Heiles-start
 released-chain released-chain-start
 standard-map standard-map-by-hand
 (struct-out motion) motions)

;; derivative : of a state whose first component is the time
;; output-step : how often the state is wanted, or 0.0
;; by-hand : statements in C that store in dy the slope at y, or #f
(struct motion (name derivative start end tolerance output-step by-hand))

;; ---------------------------------------------------------------------------
;; The driven pendulum: m = l = 1, g = 9.8, a pivot moved by 0.1 cos 2√9.8 t

(define ((L-driven-pendulum m l g ys) (up t angle v))
  (define pivot ((D ys) t))
  (+ (* 1/2 m (+ (square (* l v)) (square pivot) (* 2 l v pivot (sin angle))))
     (* m g (- (* l (cos angle)) (ys t)))))

(define ((drive amplitude frequency) t) (* amplitude (cos (* frequency t))))

(define (driven-pendulum m l g amplitude frequency)
  (Lagrangian->state-derivative (L-driven-pendulum m l g (drive amplitude frequency))))

(define driven-parameters (list 1.0 1.0 9.8 0.1 (* 2.0 (sqrt 9.8))))

(define driven-by-hand #<<C
    const double g = 9.8, a = 0.1, f = 2*sqrt(9.8);
    dy[0] = 1;
    dy[1] = y[2];
    dy[2] = (a*f*f*cos(f*y[0]) - g)*sin(y[1]);

C
  )

;; ---------------------------------------------------------------------------
;; Hénon and Heiles's two coordinates (SICM 3.6.3), at energy 1/12

(define (V-Henon-Heiles x y)
  (+ (* 1/2 (+ (square x) (square y))) (* (square x) y) (* -1/3 (cube y))))

(define (H-Henon-Heiles (up t (up x y) (down px py)))
  (+ (* 1/2 (+ (square px) (square py))) (V-Henon-Heiles x y)))

(define (Henon-Heiles s)
  (up 1 (((partial 2) H-Henon-Heiles) s) (- (((partial 1) H-Henon-Heiles) s))))

;; On the section x = 0 with p_x > 0.
(define (Henon-Heiles-start E y py)
  (define px (sqrt (- (* 2 (- E (V-Henon-Heiles 0 y))) (square py))))
  (up 0.0 (up 0.0 y) (down px py)))

(define Henon-Heiles-by-hand #<<C
    dy[0] = 1;
    dy[1] = y[3];
    dy[2] = y[4];
    dy[3] = -y[1] - 2*y[1]*y[2];
    dy[4] = -y[2] - y[1]*y[1] + y[2]*y[2];

C
  )

;; ---------------------------------------------------------------------------
;; A free rigid body in Euler angles (SICM 2.8.1)

(define (rigid-body)
  (Lagrangian->state-derivative (rigid-body-Lagrangian 1.0 (sqrt 2.0) 2.0)))
(define rigid-body-start (up 0.0 (up 1.0 0.0 0.0) (up 0.1 0.1 0.1)))

;; Angular velocities along the principal axes, Euler's equations for their rates,
;; and back to the angles.
(define rigid-body-by-hand #<<C
    const double A = 1, B = sqrt(2.0), C = 2;
    double st = sin(y[1]), ct = cos(y[1]), ss = sin(y[3]), cs = cos(y[3]);
    double vt = y[4], vf = y[5], vs = y[6];
    double wa = vt*cs + vf*st*ss, wb = vf*st*cs - vt*ss, wc = vf*ct + vs;
    double ra = (B - C)*wb*wc/A, rb = (C - A)*wc*wa/B, rc = (A - B)*wa*wb/C;
    double p = ra + vt*vs*ss - vf*vt*ct*ss - vf*vs*st*cs;
    double q = rb + vt*vs*cs - vf*vt*ct*cs + vf*vs*st*ss;
    dy[0] = 1;
    dy[1] = vt;
    dy[2] = vf;
    dy[3] = vs;
    dy[4] = p*cs - q*ss;
    dy[5] = (p*ss + q*cs)/st;
    dy[6] = rc + vf*vt*st - dy[5]*ct;

C
  )

;; ---------------------------------------------------------------------------
;; Sun, Jupiter and Saturn, nearly: three bodies in space, 18 variables and the time

(define masses '(1.0 1e-3 3e-4))

(define (three-bodies s)
  (define r (coordinate s))
  (define (pull i)
    (apply + (for/list ([j 3] [m masses] #:unless (= i j))
               (define d (- (ref r j) (ref r i)))
               (* m (/ d (expt (square d) 3/2))))))
  (up 1 (velocity s) (up (pull 0) (pull 1) (pull 2))))

(define three-bodies-start
  (up 0.0
      (up (up 0.0 0.0 0.0) (up 5.2 0.0 0.1) (up 0.0 9.5 -0.3))
      (up (up 0.0 -4e-4 0.0) (up 0.02 0.43 0.0) (up -0.32 0.01 0.01))))

(define three-bodies-by-hand #<<C
    static const double m[] = {1, 1e-3, 3e-4};
    const double *r = y + 1, *v = y + 10;
    double *dr = dy + 1, *dv = dy + 10;
    dy[0] = 1;
    for (int i = 0; i < 9; i++) { dr[i] = v[i]; dv[i] = 0; }
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < i; j++) {
            double a = r[3*j] - r[3*i], b = r[3*j + 1] - r[3*i + 1], c = r[3*j + 2] - r[3*i + 2];
            double square = a*a + b*b + c*c, f = 1/(square*sqrt(square));
            dv[3*i] += m[j]*f*a; dv[3*i + 1] += m[j]*f*b; dv[3*i + 2] += m[j]*f*c;
            dv[3*j] -= m[i]*f*a; dv[3*j + 1] -= m[i]*f*b; dv[3*j + 2] -= m[i]*f*c;
        }

C
  )

;; ---------------------------------------------------------------------------
;; Equal links, m = l = 1, g = 9.8, released at 1 rad

(define (released-chain n) (Lagrangian->state-derivative (chain-Lagrangian/equal n)))

(define (released-chain-start n)
  (define angles (vector->up (make-vector n 1.0)))
  (up 0.0 angles (* 0.0 angles)))

;; ---------------------------------------------------------------------------
;; The standard map (SICM 3.9), and n times the same in C from (x, y) in p

(define ((standard-map K) theta I return failure)
  (define nI (+ I (* K (sin theta))))
  (return ((principal-value :2pi) (+ theta nI)) ((principal-value :2pi) nI)))

(define standard-map-by-hand #<<C
static double wrap(double x)
{
    const double turn = 6.283185307179586;
    return 0 <= x && x < turn ? x : x - turn*floor(x/turn);
}

void standard_map(double *p, long n)
{
    double x = p[0], y = p[1];
    while (n-- > 0) {
        double z = y + 0.6*sin(x);
        x = wrap(x + z);
        y = wrap(z);
    }
    p[0] = x;
    p[1] = y;
}

C
  )

;; ---------------------------------------------------------------------------

(define (motions)
  (list
   (motion "driven pendulum, 10 001 outputs" (apply driven-pendulum driven-parameters)
           (up 0.0 1.0 0.0) 100.0 1e-13 0.01 driven-by-hand)
   (motion "the same without outputs" (apply driven-pendulum driven-parameters)
           (up 0.0 1.0 0.0) 100.0 1e-13 0.0 driven-by-hand)
   (motion "Hénon–Heiles" Henon-Heiles (Henon-Heiles-start 1/12 0.1 0.0)
           1000.0 1e-12 0.0 Henon-Heiles-by-hand)
   (motion "rigid body in Euler angles" (rigid-body) rigid-body-start
           1000.0 1e-12 0.0 rigid-body-by-hand)
   (motion "three bodies in space" three-bodies three-bodies-start
           10000.0 1e-12 0.0 three-bodies-by-hand)
   (motion "chain of 8 links" (released-chain 8) (released-chain-start 8)
           1.0 1e-10 0.0 #f)))
