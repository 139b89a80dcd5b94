#lang racket/base
;; Every example that follows a motion exports as C: the strictest compiler takes it, and its
;; rates are our own to the last bit at seeded states near the start.
;;
;; A few here; all under `make test-export`, which sets MECHANICS_EXPORT_ALL.

(require ffi/unsafe
         racket/file
         racket/flonum
         (only-in racket/list split-at)
         racket/path
         racket/runtime-path
         mechanics/compile/Racket-code mechanics/compile/program
         mechanics/scale/export/export-system mechanics/scale/export/exported-system
         mechanics/lang/command/program-systems
         tests/mechanics/support/exported tests/mechanics/support/random
         tests/mechanics/support/skip
         "../../support/checks.rkt" "../../support/folder.rkt")

(define-runtime-path examples "../../../../examples/mechanics")

(define all? (and (getenv "MECHANICS_EXPORT_ALL") #t))
(define states (if all? 1000 100))

(define a-few
  '("chapter-1/driven-pendulum.rkt" "constraints/slack-string.rkt" "figures/figure-2-2.rkt"))

;; Examples without code, by file and name, with the reason.
(define table '())

;; The others draw and grade.
(define folders '("animations" "chapter-1" "constraints" "exercises" "figures" "forces"
                  "questions" "rigid" "variational"))

(define (every-file)
  (for*/list ([folder (in-list folders)]
              [file (in-list (directory-list (build-path examples folder)))]
              #:when (path-has-extension? file #".rkt"))
    (format "~a/~a" folder file)))

;; They define functions that follow motions, for others.
(define for-others '("figures/orbits.rkt" "figures/star.rkt" "figures/swarm.rkt"))

;; Does its own text, without its submodules, follow a motion?
(define (follows? file)
  (define text (file->string (build-path examples file)))
  (define own (regexp-replace #rx"\n\\(module[+*].*$" text ""))
  (regexp-match? #rx"[(](evolve|evolve-trajectory|state-advancer) " own))

(define (with-libraries s use)
  (with-folder (folder)
    (define to (build-path folder "C"))
    (write-exported 'test s 'C to #f "")
    (define library (build-path to "rates.so"))
    (run-in to "cc" "-std=c99" "-O2" "-Wall" "-Wextra" "-Werror" "-ffp-contract=off" "-fPIC"
            "-shared" "-o" (path->string library) (string-append (exported-name s) ".c") "-lm")
    (use (ffi-lib library))))

;; Racket's own hyperbolic functions are not those of C.
(define own-functions '(sinh cosh tanh asinh acosh atanh erf))
(define (exact? p)
  (for/and ([i (in-vector (program-instructions p))])
    (not (memq (instruction-operation i) own-functions))))

(define (same? a b exact?)
  (or (eqv? a b)
      (and (not (= a a)) (not (= b b)))
      (and (not exact?) (<= (abs (- a b)) (* 1e-14 (+ 1.0 (abs a) (abs b)))))))

(define (near start)
  (for/flvector #:length (length start) ([x (in-list start)])
    (+ x (* (+ 0.1 (* 0.1 (abs x))) (random-flonum)))))

(define (check-rates file f)
  (define s (candidate-system f))
  (define n (exported-size s))
  (define ours! ((program->maker (exported-slope s))))
  (define m (exported-parameter-count s))
  (define numbers (candidate-start f))
  (define-values (start ps)
    (if (and numbers (= (length numbers) (+ n m)))
        (split-at numbers n)
        (values (for/list ([_ n]) 1.0) (for/list ([_ m]) 1.5))))
  (define p (apply flvector ps))
  (with-libraries
   s
   (lambda (library)
     (define theirs (exported-function library (format "~a_derivative" (exported-name s)) n))
     (define expected (make-flvector n))
     (with-seed 17
       (for ([_ states])
         (define y (near start))
         (ours! (apply flvector (append (for/list ([x (in-flvector y)]) x) ps)) expected)
         (define found (theirs y p))
         (with-check-info (['file file] ['system (exported-name s)] ['state y]
                           ['found found] ['expected expected])
           (check-true (for/and ([a (in-flvector found)] [b (in-flvector expected)])
                         (same? a b (exact? (exported-slope s)))))))))))

(define (check-example file)
  (define r (program-systems 'test (simple-form-path (build-path examples file)) file))
  (check-false (findings-error r) file)
  (when (and (follows? file) (not (member file for-others)))
    (check-pred pair? (findings-systems r) file))
  (for ([f (in-list (findings-systems r))])
    (define s (candidate-system f))
    (if (exported? s)
        (check-rates file f)
        (check-equal? (list file (candidate-name f) s)
                      (or (assoc file table) (list file (candidate-name f) "exported"))))))

(skip-unless compiler? "exported examples: there is no cc and make"
  (for ([file (in-list (if all? (every-file) a-few))])
    (test-case (format "~a exports, with our own rates to the last bit" file)
      (check-example file)))
  (unless all? (skip "exported examples: all of them are tried by make test-export")))
