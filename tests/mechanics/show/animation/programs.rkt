#lang racket/base
;; The animations are programs: each writes the files that are named on its command line, which two
;; are asked for here; of the others single pictures are looked at.
;; The tests of their motions stand beside them, and are run here.

(require (only-in mechanics/animate animation-frame)
         (only-in mechanics/show/animation/on-demand why-no-pictures)
         (only-in mechanics/book)
         (only-in mechanics/geometry)
         (only-in pict pict->argb-pixels)
         racket/file
         racket/path
         racket/runtime-path
         racket/string
         "../../support/checks.rkt" "../../support/example-programs.rkt" "../../support/gif.rkt"
         "../../support/picture-programs.rkt" "../../support/skip.rkt")

(define-runtime-path folder "../../../../examples/mechanics/animations")

(define (name-of file) (path->string (path-replace-extension (file-name-from-path file) #"")))

(define programs
  (for/list ([file (in-list (directory-list folder #:build? #t))]
             #:when (path-has-extension? file #".rkt")
             #:unless (equal? (name-of file) "save"))
    file))

(define-namespace-anchor here)

(define (make-namespace)
  (loaded-from here 'rackunit 'mechanics 'mechanics/animate 'mechanics/book 'mechanics/geometry))

;; Its output, run as a program with these arguments; again in another namespace, where
;; it was not run before.
(define (run program #:in [namespace (make-namespace)] . arguments)
  (apply run-example namespace `(submod ,program main) arguments))

;; Loads the drawing library, or finds that it is not there.
(define problem (why-no-pictures))

;; Programs that are run once share what they load.
(define shared (make-namespace))

;; name, first and last time, drawing
(define animations
  '(("Atwood-machines" 0.0 0.5 "draw-Atwood-machine #:length 3 #:masses (list 4 1 3)")
    ("Foucault-pendulum" 0.0 31.41592653589793 "draw-Foucault-pendulum #:range 1")
    ("Kepler-orbit" 0.0 6.283185307179586 "draw-orbit #:range 2")
    ("bead-on-ring" 0.0 4 "draw-bead-on-ring #:radius 1 #:angular-velocity 4.5")
    ("coupled-oscillators" 0.0 14.0 "draw-oscillator #:masses 2 #:length 1")
    ("double-pendulum" 0.0 10.0 "draw-pendulum-chain #:lengths (list 1 1)")
    ("heavy-top" 0.0 1.0 "draw-top #:length 1 #:radius 0.4")
    ("pendulum" 0.0 7.0 "draw-pendulum #:length 1")
    ("pendulum-through-pole" 0.0 12.0 "draw-spherical-pendulum #:length 1")
    ("rolling-wheel" 0.0 6.0 "draw-wheel #:radius 1.0 #:slope 0.12 #:range 11")
    ("slider-crank" 0.0 6.0 "make-drawing -1.5 4.4 -1.5 1.5 engine")
    ("spring-pendulum" 0.0 20.0 "draw-spring-pendulum #:length 1")
    ("three-bodies" 0.0 6.32591398 "draw-bodies #:masses (list 1 1 1) #:range 1.3")
    ("upright-pendulum" 0.0 4.0 "draw-driven-pendulum #:length 1.0 #:support support")))

(test-case "all animations are there"
  (check-equal? (sort (map name-of programs) string<?) (sort (map car animations) string<?)))

(skip-unless (not problem)
             "the shared libraries of racket/draw are not installed: no animations"

  (test-case "without a name it writes a GIF of its own"
    (in-a-folder
     (run (build-path folder "Atwood-machines.rkt"))
     (check-equal? (map path->string (directory-list)) '("Atwood-machines.gif"))
     (check-true (> (length (gif-images (parse-gif (file->bytes "Atwood-machines.gif")))) 50)))))

;; ---------------------------------------------------------------------------
;; Each, and what is tested beside it

(define (check-writes program)
  (in-a-folder
   (check-true (string-suffix? (run program "motion.html" #:in shared) "written: motion.html\n"))
   (check-equal? (map path->string (directory-list)) '("motion.html"))
   (check-true (< 20000 (file-size "motion.html") 1000000))))

;; It prints what is animated; the picture at the start, after a third of the time and at the end
;; differ.
(define (check-moves program from to drawing)
  (define-values (animation printed) (animation-of program))
  (check-equal? printed (format "(animation from ~a to ~a of (~a))\n" from to drawing))
  (define (pixels share)
    (pict->argb-pixels (animation-frame animation (+ from (* share (- to from))))))
  (define start (pixels 0))
  (for ([share '(1/3 1)])
    (define changed (for/sum ([a (in-bytes start)] [b (in-bytes (pixels share))]) (if (= a b) 0 1)))
    (check-true (> changed 2000) (format "after ~a of the time: ~a" share changed))))

;; -> the animation, what the program prints without arguments of its own
(define (animation-of program)
  (define out (open-output-string))
  (define animation
    (parameterize ([current-namespace shared] [current-output-port out])
      (dynamic-require program 'animation)))
  (values animation (get-output-string out)))

(for ([program (in-list programs)])
  (define name (name-of program))
  (alone (format "the tests of ~a" name)
         (unless problem
           (test-case (format "the pictures of ~a move" name)
             (apply check-moves program (cdr (assoc name animations))))
           (check-true (parameterize ([current-namespace shared])
                         (module-declared? `(submod ,program main) #t))
                       name)
           (when (member name '("Kepler-orbit" "pendulum"))
             (test-case (format "~a writes a page" name) (check-writes program))))
         (test-example shared program)))
