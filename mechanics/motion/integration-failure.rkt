#lang racket/base
;; The reason why a motion cannot be followed any further, in words, and advice.

(require racket/flonum
         "system/check.rkt" "system/singular-coordinate.rkt" "system/system.rkt"
         "../error/failure.rkt"
         "../generic/describe.rkt"
         "../lagrangian/state-derivative.rkt"
         "../numeric/finite-number.rkt" "../numeric/flvector.rkt"
         "../numeric/ode/stepper.rkt"
         "../value/shape.rkt")

(provide raise-stuck raise-cut-short (struct-out cut-short))

;; A motion that goes no further; cause : the text of the state derivative's failure there, or #f
(struct cut-short exn:fail:mechanics:singular (cause))

;; s : system; m : method; t, y : the last time and the state there; why : a symbol of
;; numeric/ode/integrate.rkt; kept : the value that the failure carries
(define (raise-stuck who s m t y why kept)
  (raise-cut-short who why t (system-state s y) kept (hints s m y why) (cause s y why)))

;; t : the time, or #f; hints : lines of the message after the time and the last state
(define (raise-cut-short who why t state kept [hints ""] [cause #f])
  (define too-many? (eq? why 'too-many-steps))
  (define message
    (format "~a~a\n  last state: ~a~a"
            (if too-many?
                "the motion takes more steps than allowed"
                "the motion cannot be followed any further")
            (if t (format "\n  time: ~a" t) "") (value->text state) hints))
  (if too-many?
      (raise-not-convergent who message kept #f #:show? #f)
      (raise (cut-short (format "~a: ~a" who message) (current-continuation-marks) kept cause))))

(define (hints s m y why)
  (define singular (if (method-step m) "" (singular-coordinate-text s y)))
  (case why
    [(too-many-steps)
     (cond [(not (equal? singular "")) singular]
           [(or (method-step m) (eq? 'jacobian (method-asks m))) ""]
           [else "\n  if it is stiff, use the method 'Radau-IIA-5"])]
    ;; there, any other error than that of having no value is the user's to see
    [(no-slope) (string-append (or (slope-text s y "there") "") singular)]
    [(step-fails) (string-append (step-text m) (advice m))]
    [(lost-digits)
     (string-append "\n  rounding in the state derivative is more than the tolerance allows"
                    (if (equal? singular "") nearly-singular singular))]
    [else
     (string-append (if (method-step m) (step-text m) "")
                    (or (beyond-text s y) (short-text m why))
                    singular)]))

(define nearly-singular
  (string-append "\n  take a greater tolerance; or other coordinates, if these are nearly singular "
                 "there, as angles\n  are where a motion passes near the axis that they turn about"))

(define (short-text m why)
  (cond [(eq? why 'boundary) "\n  the state derivative is not finite beyond"]
        ;; they are a part of the radius of convergence
        [(eq? 'expansion (method-asks m))
         (string-append "\n  the motion is singular there: "
                        "steps became too short to change the time")]
        [else "\n  steps became too short to change the time"]))

;; A line on the state derivative; #f if it is finite.
(define (slope-text s y where)
  (or (refusal-text s y where no-value?)
      (let ([slope ((system-derivative s) (system-state s y))])
        (and (not (andmap finite? (map real-number (scalars slope))))
             (format "\n  state derivative ~a: ~a" where (value->text slope))))))

;; The message of a failure of that kind that the state derivative raises, or #f.
(define (refusal-text s y where kind?)
  (with-handlers ([exn:fail:mechanics:singular:matrix?
                   (lambda (e)
                     (string-append (format "\n  the mass matrix has no inverse ~a" where)
                                    (directions->text e)))]
                  [kind? (lambda (e) (failure-text where e))])
    ((system-derivative s) (system-state s y))
    #f))

;; The failure of the state derivative that the hints quote, or #f.
(define (cause s y why)
  (case why
    [(too-many-steps step-fails lost-digits) #f]
    [else
     (or (refusal-text s y "there" no-value?)
         (and (not (eq? why 'no-slope))
              (around s y (lambda (y) (refusal-text s y "beyond" exn:fail?)))))]))

(define (failure-text where e) (format "\n  ~a: ~a" where (exn-message e)))

;; A line on the state derivative there, or a little further on either side: formulas may fail
;; where compiled code does not, and beyond the motion any error is an answer.
(define (beyond-text s y) (or (slope-text s y "there") (slope-text-around s y)))

(define (slope-text-around s y)
  (define (text y)
    (with-handlers ([exn:fail? (lambda (e) (failure-text "beyond" e))])
      (slope-text s y "beyond")))
  (around s y text))

;; (text y) at the first place near the state where it is not #f
(define (around s y text)
  (define slope (scalars ((system-derivative s) (system-state s y))))
  (define (after h)
    (along y h (for/flvector #:length (flvector-length y) ([v (in-list slope)])
                 (real->double-flonum (real-number v)))))
  (for/or ([h (in-list '(1e-9 -1e-9 1e-6 -1e-6))]) (text (after h))))

(define (step-text m) (format "\n  length of a step: ~a" (method-step m)))

;; Advice where a step of fixed length fails.
(define (advice m)
  (format "\n  take a shorter step, such as (~a ~a), or a method that chooses its own"
          (method-name m) (/ (method-step m) 4)))
